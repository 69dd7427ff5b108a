-- Code that runs when garbage is collected.
local fr = require "flyrock"
setmetatable({}, { __gc = function() while true do end end })
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
