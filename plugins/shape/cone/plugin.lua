local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "cone",
  doc = "A cone (3D) about its own z axis, its point up. It stands on its flat base, and lies on its side along a line, on which it rolls around its point.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 10 }, doc = "radius of the base" },
    height = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "from the base to the point" },
  },
  native = "cone",
}
