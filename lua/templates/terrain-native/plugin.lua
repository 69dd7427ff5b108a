-- The manifest of a native terrain: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "my_terrain",
  dimension = 2,
  doc = "A level, a slope of 45 degrees and a level.",
  params = {
    drop = fr.number { default = 20, above = 0, unit = "m", doc = "height of the slope" },
  },
  native = "my_terrain",
}
