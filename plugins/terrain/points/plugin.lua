local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "points",
  doc = "The ground from the points of a laser scan or a survey, in 3D, of one part without a name: the mean height in each cell of a "
    .. "grid, or triangles between the points.",
  params = {
    file = fr.file { doc = "XYZ (.xyz, .asc, .txt, .csv, .pts: lines of x, y, z and more, with or without heads such as `id;easting;northing;elevation` and a first line with the count) or LAS 1.2 to 1.4 (.las)" },
    class = fr.integer {
      optional = true,
      min = 0,
      max = 255,
      doc = "of LAS: only the points of this class, 2 for the ground; all points where it is left out",
    },
    cell = fr.number {
      optional = true,
      above = 0,
      unit = "m",
      doc = "side of the cells of a grid whose first centre is the least x and y of the points; or `triangulate`",
    },
    triangulate = fr.boolean { default = false, doc = "true: triangles between the points (Delaunay in plan)" },
    max_gap = fr.number {
      optional = true,
      min = 0,
      unit = "m",
      doc = "cells: voids inside that lie in a square of this side get the heights of a membrane over their edge, others have no "
        .. "ground; 0 where it is left out. Triangles: those with a longer side are left out",
    },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file" },
  },
  native = "points",
}
