-- A scenario from a coroutine, in a plugin.
local fr = require "flyrock"
coroutine.wrap(fr.scenario) {}
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
