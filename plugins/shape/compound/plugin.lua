local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "compound",
  doc = "A rigid rock of several shapes, which may be non-convex. Each part is a convex shape or another compound, with its "
    .. "own parameters, and its place: its origin is at `at`, turned by `turn` (0 by default). Mass, centre and inertia are "
    .. "the sums of the parts: a volume that two parts share counts twice, and `flyrock check` warns of it.",
  params = {
    parts = fr.shapes { doc = "{ type, ..., at, turn }; turn is an angle in 2D, { axis, angle } or a quaternion [w, x, y, z] in 3D" },
  },
  native = "compound",
}
