local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "fixed",
  doc = "A launch at a given velocity: its components in the world frame, or speed and direction.",
  params = {
    velocity = fr.vector { optional = true, unit = "m/s", usual = { -300, 300 }, doc = "components in the world frame, in place of speed" },
    speed = fr.number { optional = true, min = 0, unit = "m/s", usual = { 0, 300 }, doc = "magnitude, with elevation" },
    elevation = fr.number {
      optional = true, unit = "deg",
      doc = "above the outward horizontal of the face (elsewhere +x); with `speed`, 45 deg where it is left out",
    },
    azimuth = fr.number { optional = true, unit = "deg", doc = "turn about the vertical from the face, 3D; 0 where it is left out; or `bearing`" },
    spin = fr.spin { default = 0, unit = "rad/s", usual = { -500, 500 }, doc = "anticlockwise; in 3D its components in the world frame" },
  },
  native = "fixed",
}
