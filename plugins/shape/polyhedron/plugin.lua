local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "polyhedron",
  doc = "A convex polyhedron (3D): the hull of its points, in any order, or a closed convex surface. For a rock that is not "
    .. "convex see shape/compound.",
  params = {
    points = fr.points { optional = true, unit = "m", doc = "[[x, y, z], ...], in place of a file" },
    file = fr.file {
      optional = true,
      doc = "an OBJ, PLY or STL file in metres, a closed convex surface with its faces outwards (an OBJ file without faces: the hull of "
        .. "its vertices); or a text file of three numbers in metres a line, apart by commas, blanks or semicolons, # begins a comment",
    },
  },
  native = "polyhedron",
}
