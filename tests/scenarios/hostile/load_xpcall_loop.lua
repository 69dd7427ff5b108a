-- A handler that does not come back.
local fr = require "flyrock"
while true do xpcall(function() while true do end end, function() while true do end end) end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
