local fr = require "flyrock"
local points = io.open("profile.csv")
return fr.scenario { flyrock = 1 }
