-- A table that grows.
local fr = require "flyrock"
local rows, text = {}, ("x"):rep(1e6)
while true do rows[#rows + 1] = text .. #rows end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
