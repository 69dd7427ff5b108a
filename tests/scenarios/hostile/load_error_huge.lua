-- An error of a megabyte.
local fr = require "flyrock"
error(("x"):rep(1e6))
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
