-- A module that is no text.
local fr = require "flyrock"
require "parts.binary"
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
