-- The manifest of a native shape: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "my_shape",
  doc = "A slab twice as long as high; in 3D of square plan.",
  params = {
    size = fr.number { default = 0.5, above = 0, unit = "m", doc = "its length" },
  },
  native = "my_shape",
}
