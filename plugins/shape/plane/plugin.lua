local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "plane",
  doc = "A plane without end (3D): the half space below it is solid. It goes through the body's position; its normal is the body's "
    .. "own z axis. It has no mass, so its body is fixed or driven: a wall of a box, a moving floor, a tilting table.",
  params = {},
  native = "plane",
}
