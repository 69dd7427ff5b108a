-- Moves a billion of nothing.
local fr = require "flyrock"
table.move({}, 1, 1e15, 2)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
