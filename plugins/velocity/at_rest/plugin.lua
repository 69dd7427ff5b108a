local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "at_rest",
  doc = "No launch: the rock starts at rest and falls. What a rock without `launch` does, by name, for tables that compare models.",
  reads = {},
  launch = function(p, rock)
    return { velocity = rock:direction(0, 0) }
  end,
}
