-- Unpacks a billion of nothing.
local fr = require "flyrock"
local n = select("#", table.unpack({}, 1, 1e8))
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
