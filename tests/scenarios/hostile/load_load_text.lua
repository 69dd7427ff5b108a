-- Code from a text.
local fr = require "flyrock"
load("while true do end")()
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
