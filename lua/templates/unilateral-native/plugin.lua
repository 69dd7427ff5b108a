-- The manifest of a native unilateral law: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "my_condition",
  doc = "A contact that holds against a pull, 0 <= gap, r_n >= -pull, as clay sticks.",
  params = {
    pull = fr.number { default = 0, min = 0, unit = "N", doc = "greatest pull that it holds" },
  },
  native = "my_condition",
}
