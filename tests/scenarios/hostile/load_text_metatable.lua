-- The metatable of texts changed.
local fr = require "flyrock"
getmetatable("").__index = {}
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
