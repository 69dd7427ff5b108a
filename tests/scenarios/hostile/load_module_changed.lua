-- The module flyrock changed.
local fr = require "flyrock"
fr.number = nil
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
