-- A function of a library replaced.
local fr = require "flyrock"
math.sqrt = nil
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
