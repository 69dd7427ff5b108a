-- An error that is a table with a text that lies.
local fr = require "flyrock"
error(setmetatable({}, { __tostring = function() return "fine" end }))
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
