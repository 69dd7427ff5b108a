-- A metatable set on a library.
local fr = require "flyrock"
setmetatable(string, { __index = function() return 0 end })
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
