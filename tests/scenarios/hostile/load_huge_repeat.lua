-- A text of a terabyte.
local fr = require "flyrock"
local text = ("x"):rep(1e12)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
