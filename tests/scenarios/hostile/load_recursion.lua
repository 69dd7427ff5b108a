-- A function that calls itself.
local fr = require "flyrock"
local function down(n) return 1 + down(n + 1) end
down(1)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
