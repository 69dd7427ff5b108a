-- A module that is not there.
local fr = require "flyrock"
require "parts.nothing"
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
