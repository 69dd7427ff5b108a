-- A comparison that sorts.
local fr = require "flyrock"
local function sort() table.sort({ 3, 2, 1 }, function(a, b) sort() return a < b end) end
sort()
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
