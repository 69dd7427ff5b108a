local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "hollow_disk",
  doc = "A drum or ring (2D), solid between two circles. It is touched from inside only, by the places of other shapes that are "
    .. "farthest from its centre: it keeps in what is inside it, and hangs on what it surrounds. The ground, other hollow shapes and "
    .. "shapes that come from outside do not touch it. A shape is inside if its middle is inside.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "of the inner circle, which is touched" },
    outer = fr.number { optional = true, above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "radius of the outer circle; 1.05 radius where it is left out" },
  },
  native = "hollow_disk",
}
