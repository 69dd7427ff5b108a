-- A table that grows.
local fr = require "flyrock"
local rows = {}
while true do rows[#rows + 1] = ("x"):rep(1e5) .. #rows end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
