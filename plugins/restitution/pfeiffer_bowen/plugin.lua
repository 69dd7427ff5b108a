local fr = require "flyrock"

-- e_n = en / (1 + (v_n / half_speed)^2): hard impacts crush the surface, slow ones bounce.
return fr.plugin {
  kind = "restitution",
  name = "pfeiffer_bowen",
  form = "newton",
  doc = "Normal restitution that fades with impact speed: e_n = en / (1 + (v_n / half_speed)^2).",
  source = "T. J. Pfeiffer and T. D. Bowen, Computer simulation of rockfalls, 1989",
  reads = { "contact.approach_speed" },
  params = {
    en = fr.number { default = 0.35, min = 0, max = 1, doc = "limit at very slow impact" },
    et = fr.number { default = 0, min = 0, max = 1, doc = "tangential restitution" },
    half_speed = fr.number { default = 9.144, above = 0, unit = "m/s", doc = "speed at which e_n is halved" },
  },
  impact = function(p, contact)
    local r = contact.approach_speed / p.half_speed
    return p.en / (1 + r * r), p.et
  end,
}
