local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "gurney",
  doc = "Launch speed of the burden from the energy of the charge: v0 = sqrt(2E) f(c/m) with "
    .. "c/m = (W/l) / (rho b^2 tan(alpha/2)) and W/l = pi/4 d^2 rho_e. Every rock of the burden starts at this speed.",
  source = "J. Roth, A model for the determination of flyrock range, USBM J0387242, 1979; R. W. Gurney 1943",
  validity = "breakout angles of 90 to 120 degrees; with roth, a charge far lighter than the rock, c/m up to 0.1. Outside "
    .. "the run warns.",
  reads = {
    "blast.explosive.density", "blast.explosive.gurney_constant", "blast.hole.diameter", "blast.burden",
    "blast.rock_density", "blast.breakout_angle",
  },
  params = {
    geometry = fr.choice {
      choices = { "roth", "cylinder", "sphere", "sandwich" }, default = "roth",
      doc = "f = sqrt(c/m), or (m/c + 1/2)^-1/2, (m/c + 3/5)^-1/2, (m/c + 1/3)^-1/2",
    },
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal of the face (elsewhere +x)" },
    azimuth = fr.number { optional = true, unit = "deg", doc = "turn about the vertical from the face, 3D; 0 where it is left out; or `bearing`" },
  },
  native = "gurney",
}
