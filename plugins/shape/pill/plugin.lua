local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "pill",
  doc = "A cylinder with half-spheres as ends (3D), along its own z axis: all places within `radius` of its axis. It lies on a plane at two points and rolls.",
  params = {
    length = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "length of its axis, between the centres of the half-spheres" },
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 10 }, doc = "radius of the cylinder and of the half-spheres" },
  },
  native = "pill",
}
