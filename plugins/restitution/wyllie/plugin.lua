local fr = require "flyrock"

-- A fit to measured impacts: shallow ones turn spin and roughness into bounce, so that e_n passes 1. A rigid polygon or
-- polyhedron shows that by itself; this law is for rocks that are round or a point, which cannot.
return fr.plugin {
  kind = "restitution",
  name = "wyllie",
  form = "newton",
  may_gain = true,
  doc = "Normal restitution by the angle of impact from the surface, e_n = factor theta_deg^exponent, above 1 for shallow "
    .. "impacts. For round and lumped rocks only: a rock with corners turns spin into bounce by itself, and would do so twice.",
  source = "D. C. Wyllie, Calibration of rock fall modeling parameters, 2014; constants as in RockGIS",
  reads = { "contact.impact_angle" },
  params = {
    factor = fr.number { default = 19.5, above = 0, doc = "e_n at an angle of 1 degree" },
    exponent = fr.number { default = -1.03, max = 0, doc = "of the angle in degrees" },
    largest = fr.number { default = 2.5, above = 0, doc = "e_n where the fit gives more: about the largest that was measured" },
  },
  impact = function(p, contact)
    return math.min(p.factor * math.deg(contact.impact_angle) ^ p.exponent, p.largest)
  end,
}
