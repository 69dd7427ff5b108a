local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "mckenzie",
  doc = "Launch at sqrt(g L), g = 9.81 m/s2, of the greatest range L = 9.74 SDoB^-2.167 d^(2/3) m (d in mm) by the scaled "
    .. "depth of burial SDoB = D / W^(1/3), with D = stemming + Lc/2 and W the mass in Lc = min(charge length, 10 d) (8 d "
    .. "below 100 mm). It gives a distance, no speed: sqrt(g L) reaches L at 45 degrees on level ground without air.",
  source = "C. K. McKenzie, Flyrock range and fragment size prediction, ISEE 2009, as of 2022",
  validity = "SDoB above 0.64 m/kg^(1/3); below it blasts are violent (recalled, unverified) and the run warns. "
    .. "The range is of the greatest throw in air: with drag, or at another angle, rocks land short of it, and the run says by "
    .. "how much. No distance for people: with design values it fell short on 254 of 264 measured blasts, because the farthest "
    .. "rock comes from the worst hole (docs/which-model.md).",
  reads = { "blast.explosive.density", "blast.hole.diameter", "blast.hole.stemming", "blast.hole.charge_length" },
  params = {
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal of the face (elsewhere +x)" },
    azimuth = fr.number { optional = true, unit = "deg", doc = "turn about the vertical from the face, 3D; 0 where it is left out; or `bearing`" },
  },
  native = "mckenzie",
}
