local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "box",
  doc = "A box (3D) with sides along its own axes.",
  params = {
    size = fr.vector { above = 0, unit = "m", doc = "lengths of its sides" },
  },
  native = "box",
}
