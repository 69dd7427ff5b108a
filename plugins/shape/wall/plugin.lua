local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "wall",
  doc = "A rectangle with half-disks as ends (2D), along its own x axis: all places within `radius` of its axis.",
  params = {
    length = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "length of its axis, between the centres of the half-disks" },
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 10 }, doc = "radius of the half-disks, half of its thickness" },
  },
  native = "wall",
}
