local fr = require "flyrock"
return fr.scenario {
  flyrock = 1,
  title = "a table that is not closed",
