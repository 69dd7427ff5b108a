local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = ("h"):rep(1e6), doc = "never reached", impact = function(p) return 0.3 end }
