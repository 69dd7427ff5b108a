-- gsub inside gsub inside gsub.
local fr = require "flyrock"
local function down() return ("x"):gsub("x", down) end
down()
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
