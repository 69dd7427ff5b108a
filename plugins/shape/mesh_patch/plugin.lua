local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "mesh_patch",
  doc = "A rigid surface of triangles from a file (3D), in general not convex: a chute, a bin, a wall of blocks. A closed surface is "
    .. "solid inside. One with a border becomes a plate, whose front it is. Rocks do not feel its flat joints. Its body is fixed, or "
    .. "driven without spin.",
  params = {
    file = fr.file { doc = "an OBJ, PLY or STL file; corners counter-clockwise, seen from outside; the frame of the body" },
    up = fr.choice { choices = { "z", "y" }, default = "z", doc = "which axis of the file points up" },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file" },
    thickness = fr.number {
      optional = true, above = 0, unit = "m",
      doc = "of a surface with a border, behind it; where it is left out 5 % of its size, or less where it bends too sharply for that",
    },
  },
  native = "mesh_patch",
}
