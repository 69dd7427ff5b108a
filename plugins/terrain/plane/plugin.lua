local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "plane",
  doc = "A plane with the ground below it, of one part without a name. In 3D it has no ends, in 2D it reaches 1 km to both "
    .. "sides of its point.",
  params = {
    point = fr.vector { optional = true, unit = "m", doc = "a point of it; the origin where it is left out" },
    normal = fr.vector {
      optional = true,
      doc = "at right angles to it, of any length and either direction; upright where it is left out",
    },
  },
  native = "plane",
}
