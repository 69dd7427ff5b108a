-- A loop without an end.
local fr = require "flyrock"
while true do end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
