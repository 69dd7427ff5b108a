local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "random_polyhedron",
  doc = "A convex polyhedron drawn at random (3D): points spread over an ellipsoid, each moved at random, and their hull.",
  params = {
    vertices = fr.integer { default = 12, min = 6, max = 100, doc = "number of points" },
    diameter = fr.number { above = 0, unit = "m", usual = { 0.001, 20 }, doc = "of the sphere of equal volume" },
    irregularity = fr.number {
      default = 0.5, min = 0, max = 1,
      doc = "how far a point is moved at most, in units of half the distance between neighbours; 0 is regular",
    },
    elongation = fr.number { default = 1, min = 0.05, max = 1, doc = "intermediate over longest axis" },
    flatness = fr.number { default = 1, min = 0.05, max = 1, doc = "shortest over intermediate axis" },
  },
  native = "random_polyhedron",
}
