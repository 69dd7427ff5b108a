local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "cylinder",
  doc = "A cylinder with flat ends (3D) about its own z axis: a drum, a core of rock, a disk, a coin. It is round to the last digit: it rolls on its side along a line and on its rim at one place, and stands on its ends.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 10 }, doc = "radius" },
    height = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "length along the axis, from one flat end to the other" },
  },
  native = "cylinder",
}
