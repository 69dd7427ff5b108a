-- A length that lies.
local fr = require "flyrock"
table.concat(setmetatable({}, { __len = function() return 1 << 60 end, __index = function() return "x" end }))
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
