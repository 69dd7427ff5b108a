local fr = require "flyrock"
local sizes = { small = 0.2 }

local diameter = sizes.medium * 2
return fr.scenario { flyrock = 1, dimension = 2, diameter = diameter }
