local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "mesh",
  doc = "A surface of triangles from a file, in 3D. Overhangs and upright faces are allowed. The groups and objects of an "
    .. "OBJ file are parts.",
  params = {
    file = fr.file { doc = "an OBJ or STL file in metres; corners counter-clockwise, seen from outside of the ground" },
    up = fr.choice { choices = { "z", "y" }, default = "z", doc = "which axis of the file points up" },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file" },
  },
  native = "mesh",
}
