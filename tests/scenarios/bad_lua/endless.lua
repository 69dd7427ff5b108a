local fr = require "flyrock"
while true do pcall(function() while true do end end) end
return fr.scenario { flyrock = 1 }
