local fr = require "flyrock"

-- Tables of R_n by soil type are not shipped, because nobody here read them in their source.
return fr.plugin {
  kind = "restitution",
  name = "rockyfor3d",
  form = "velocity",
  doc = "R_n of the soil, which fades with speed, and R_t from the height of obstacles: v_n+ = -rn / (1 + (v_n / half_speed)^2) v_n-, "
    .. "v_t+ = v_t- / (1 + (obstacle + penetration) / R) with the radius R of the rock, whatever the friction. For lumped masses and "
    .. "round shapes: at the deepest contact of the instant, the others have e = 0.",
  source = "Rockyfor3D (L. Dorren); both formulas and 9 m/s are recalled, unverified. Give rn and obstacle of your soil",
  reads = { "contact.approach_speed", "contact.radius" },
  params = {
    rn = fr.number { min = 0, max = 1, doc = "of the soil type, at a slow impact" },
    half_speed = fr.number { default = 9, above = 0, unit = "m/s", doc = "normal speed at which R_n is halved" },
    obstacle = fr.number { default = 0, min = 0, unit = "m", doc = "height of the obstacles that the rock meets; may be drawn `per: impact`" },
    penetration = fr.number { default = 0, min = 0, unit = "m", doc = "depth to which the rock sinks in" },
  },
  impact = function(p, contact)
    local v = contact.approach_speed / p.half_speed
    return p.rn / (1 + v * v), 1 / (1 + (p.obstacle + p.penetration) / contact.radius)
  end,
}
