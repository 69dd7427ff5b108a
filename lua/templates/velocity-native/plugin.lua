-- The manifest of a native launch model: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "my_launch",
  reads = { "blast.burden", "blast.hole.diameter", "blast.explosive.density" },
  doc = "Speed that falls with the burden over the root of the charge per metre, v = k (sqrt(W/l)/b)^1.3.",
  params = {
    k = fr.number { default = 13.5, above = 0, unit = "m/s", doc = "speed at a scaled burden of 1" },
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal" },
  },
  native = "my_launch",
}
