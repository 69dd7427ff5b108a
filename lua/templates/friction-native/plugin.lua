-- The manifest of a native friction law: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "my_friction",
  doc = "Dry friction |r_t| <= mu r_n.",
  params = {
    mu = fr.number { default = 0.6, min = 0, doc = "coefficient of friction" },
  },
  native = "my_friction",
}
