-- Modules that require each other.
local fr = require "flyrock"
require "parts.circle_a"
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
