local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "plane",
  doc = "A plane without ends (3D).",
  params = {
    point = fr.vector { optional = true, unit = "m", doc = "a point of it; the origin where it is left out" },
    normal = fr.vector { optional = true, doc = "of any length and either sense, not horizontal; vertical where it is left out" },
  },
  native = "plane",
}
