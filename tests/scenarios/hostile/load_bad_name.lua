local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "caf\xe9\27[2J", doc = "no UTF-8", impact = function(p) return 0.3 end }
