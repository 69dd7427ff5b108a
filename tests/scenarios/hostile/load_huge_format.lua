-- A field of a billion characters.
local fr = require "flyrock"
local text = ("%999999999d"):format(1)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
