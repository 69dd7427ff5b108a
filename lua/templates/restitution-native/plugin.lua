-- The manifest of a native restitution law: build it with CMake (CMakeLists.txt beside), then name this folder in a scenario.
local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "my_restitution",
  doc = "Newton's law: the normal velocity returns with the factor -e_n.",
  form = "newton",
  params = {
    en = fr.number { default = 0.5, min = 0, max = 1, doc = "normal restitution" },
  },
  native = "my_restitution",
}
