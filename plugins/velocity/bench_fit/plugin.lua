local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "bench_fit",
  doc = "Launch speed fitted to bench blasts: v0^2 = K f(c/m) - C, with constants for limestone and granite, ANFO or "
    .. "another explosive (as the blast says). Where v0^2 < 0 the rock starts at rest and the run says so.",
  source = "Fly-rock distance (Ninh Dan), equation 6, after J. Roth 1979",
  validity = "breakout angles of 90 to 120 degrees; charges large enough for v0^2 > 0; limestone is printed for ANFO only. "
    .. "Outside the run warns.",
  reads = {
    "blast.explosive.density", "blast.hole.diameter", "blast.burden", "blast.rock_density", "blast.breakout_angle",
  },
  params = {
    rock = fr.choice { choices = { "limestone", "granite" }, doc = "which fit; dolomite is limestone" },
    form = fr.choice {
      choices = { "linear", "as_printed" }, default = "linear",
      doc = "f = c/m, or the paper's sqrt(c/m), whose speeds are not plausible",
    },
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal of the face (elsewhere +x)" },
    azimuth = fr.number { optional = true, unit = "deg", doc = "turn about the vertical from the face, 3D; 0 where it is left out; or `bearing`" },
  },
  native = "bench_fit",
}
