-- A text that doubles.
local fr = require "flyrock"
local text = "x"
while true do text = text .. text end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
