local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "polyhedron",
  doc = "A convex polyhedron (3D): the hull of its points, in any order.",
  params = {
    points = fr.points { optional = true, unit = "m", doc = "[[x, y, z], ...], in place of a file" },
    file = fr.file {
      optional = true,
      doc = "a text file of three numbers in metres a line, apart by a comma or blanks, # begins a comment; "
        .. "of an OBJ file (.obj) its vertices",
    },
  },
  native = "polyhedron",
}
