local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "richards_moore",
  doc = "Launch speed by scaled burden or stemming: v = k (sqrt(m) / s)^1.3, with the charge per metre m [kg/m] and s [m] the "
    .. "burden (face_burst) or the stemming (cratering, stemming_ejection). At 45 degrees on level ground without air it reaches "
    .. "the published distance (k^2/g) (sqrt(m)/s)^2.6; stemming leaves along the hole and reaches sin(2 drill_angle) of that.",
  source = "A. B. Richards and A. J. Moore, Flyrock control - by chance or design, ISEE 2004",
  validity = "k is fitted to a site, to the greatest throw seen there, in air: 13.5 in soft to 27 in hard rock (recalled, "
    .. "unverified); 14 to 30 in use. Outside 13.5 to 30 the run warns. With drag, or at another angle, rocks land short of the "
    .. "published distance, and the run says by how much. No distance for people: with design values it fell short on 239 to "
    .. "263 of 264 measured blasts, four times the distance on 25 to 36 %, because the farthest rock comes from the worst hole "
    .. "(docs/which-model.md).",
  reads = {
    "blast.explosive.density", "blast.hole.diameter", "blast.burden if mode is face_burst",
    "blast.hole.stemming if mode is cratering or stemming_ejection",
  },
  params = {
    mode = fr.choice {
      choices = { "face_burst", "cratering", "stemming_ejection" }, default = "face_burst", doc = "where the gas breaks out",
    },
    k = fr.number { above = 0, doc = "speed in m/s where sqrt(m) = s (kg/m, m)" },
    drill_angle = fr.number {
      optional = true, above = 0, below = 180, unit = "deg",
      doc = "stemming_ejection: of the hole, above the outward horizontal; beyond 90 deg it throws backwards",
    },
    elevation = fr.number {
      optional = true, unit = "deg",
      doc = "other modes: above the outward horizontal of the face (elsewhere +x); 45 deg where it is left out",
    },
    azimuth = fr.number { optional = true, unit = "deg", doc = "turn about the vertical from the face, 3D; 0 where it is left out; or `bearing`" },
  },
  native = "richards_moore",
}
