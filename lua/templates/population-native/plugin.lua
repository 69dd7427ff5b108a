-- The manifest of a native population: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "my_population",
  doc = "A number of rocks that differs from trial to trial, half of them heavier.",
  params = {
    most = fr.integer { default = 5, min = 1, max = 1000, doc = "greatest number of rocks" },
  },
  native = "my_population",
}
