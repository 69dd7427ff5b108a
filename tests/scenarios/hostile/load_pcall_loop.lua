-- A loop around a pcall around a loop.
local fr = require "flyrock"
while true do pcall(function() while true do end end) end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
