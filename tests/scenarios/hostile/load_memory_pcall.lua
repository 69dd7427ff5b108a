-- A table that grows, inside pcall.
local fr = require "flyrock"
local rows = {}
while true do pcall(function() rows[#rows + 1] = ("x"):rep(1e5) .. #rows end) end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
