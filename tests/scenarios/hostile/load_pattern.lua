-- A pattern that explodes.
local fr = require "flyrock"
local found = ("a"):rep(100):find(("a*"):rep(50) .. "b")
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
