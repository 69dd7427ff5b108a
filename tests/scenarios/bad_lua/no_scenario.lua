local fr = require "flyrock"
local scenario = fr.scenario { flyrock = 1 }
