local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "point",
  doc = "A particle without extent (2D and 3D): a point of mass that slides and bounces and does not turn. It needs `mass`, because "
    .. "it has no volume; for the same reason air does not slow it. It meets the ground and all shapes that have an extent; it passes "
    .. "other points.",
  params = {},
  native = "point",
}
