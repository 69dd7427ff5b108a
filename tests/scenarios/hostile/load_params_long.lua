local fr = require "flyrock"
local params = { [("p"):rep(1e6)] = fr.number { default = 1, doc = "with a long name" } }
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", params = params, impact = function(p) return 0.3 end }
