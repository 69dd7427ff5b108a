local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "hollow_cylinder",
  doc = "A tube (3D) about its own z axis, open at both ends. It is touched from inside only, by the places of other shapes that "
    .. "are farthest from its axis: it keeps in what is inside it, and hangs on what it surrounds. The ground, other hollow shapes and "
    .. "shapes that come from outside do not touch it. A shape is inside if its middle is inside, between the two ends; the wall "
    .. "then keeps all of it in, also what sticks out of an end. The edges of the ends do not touch.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "of the inside, which is touched" },
    outer = fr.number { optional = true, above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "radius of the outside; 1.05 radius where it is left out" },
    height = fr.number { above = 0, unit = "m", usual = { 0.0005, 100 }, doc = "length along the axis, from one end to the other" },
  },
  native = "hollow_cylinder",
}
