local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "polyline",
  doc = "A line of segments (2D), in general not convex: a ramp, a trough, the outline of a hopper or of a drum. It is solid on the "
    .. "right of its direction: a line from left to right is a ground, and an outline is solid inside if its points are clockwise, "
    .. "outside if they are counter-clockwise. Rocks do not feel its flat joints. Its body is fixed, or driven without spin.",
  params = {
    points = fr.points { unit = "m", doc = "in the frame of the body; an outline ends with its first point" },
    thickness = fr.number {
      optional = true, above = 0, unit = "m",
      doc = "of a line with two ends, to its right; where it is left out 5 % of its size, or less where it bends too sharply for that",
    },
  },
  native = "polyline",
}
