local fr = require "flyrock"
local radius = math.random() * 0.5
return fr.scenario { flyrock = 1, radius = radius }
