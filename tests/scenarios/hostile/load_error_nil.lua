-- An error without a text.
local fr = require "flyrock"
error(nil)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
