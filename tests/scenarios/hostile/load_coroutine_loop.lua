-- Loops in ever new coroutines.
local fr = require "flyrock"
while true do coroutine.resume(coroutine.create(function() while true do end end)) end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
