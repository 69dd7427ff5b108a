local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "polygon",
  doc = "A convex polygon, with sharp or rounded corners: given by its vertices, or drawn at random with a number of sides and a size. "
    .. "Drawn ones have their vertices on a circle, at least 20 degrees apart (half the regular distance "
    .. "from 18 sides on), the edge between the last and the first level below.",
  params = {
    vertices = fr.points { optional = true, unit = "m", doc = "the vertices in order, in place of sides and diameter" },
    sides = fr.integer { optional = true, min = 3, max = 100, doc = "number of sides of a drawn polygon" },
    diameter = fr.number { optional = true, above = 0, unit = "m", usual = { 0.001, 20 }, doc = "diameter of the circle of equal area" },
    irregularity = fr.number {
      optional = true, min = 0, max = 1,
      doc = "of a drawn polygon: 0 is regular, 1 has vertices uniformly at random; 0.3 where it is left out",
    },
    rounding = fr.number {
      optional = true, min = 0, unit = "m", usual = { 0.0005, 10 },
      doc = "radius of the arcs that round its corners from inside, so that its sides stay where they are; "
        .. "less than what leaves each side a straight part. Its area is then smaller than that of `diameter`",
    },
  },
  native = "polygon",
}
