-- The manifest of a native rolling resistance: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "rolling",
  name = "my_rolling",
  doc = "Rolling resistance whose arm is a share of the radius of the rock.",
  params = {
    share = fr.number { default = 0.05, min = 0, doc = "arm mu_r over the radius" },
  },
  native = "my_rolling",
}
