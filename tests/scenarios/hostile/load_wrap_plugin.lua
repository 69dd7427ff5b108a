-- A registration from a coroutine whose only function is that of the host.
local fr = require "flyrock"
coroutine.wrap(fr.plugin) { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
