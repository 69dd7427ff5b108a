local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "rocfall",
  form = "velocity",
  doc = "R_n and R_t as rockfall programs scale them: rn_scaled = rn / (1 + (v_n / half_speed)^2) / (1 + (mass / half_mass)^2), "
    .. "v_n+ = -rn_scaled v_n-, v_t+ = rt v_t-, whatever the friction. For lumped masses and round shapes: at the "
    .. "deepest contact of the instant, the others have e = 0.",
  source = "RocFall's options to scale R_n by velocity and by mass; the velocity's function and 9.144 m/s: T. J. Pfeiffer and T. D. "
    .. "Bowen 1989. That the mass has a function of the same shape is recalled, unverified: it is off unless half_mass is given",
  reads = { "contact.approach_speed", "contact.mass" },
  params = {
    rn = fr.number { min = 0, max = 1, doc = "kept share of the normal velocity at a slow impact of a light rock" },
    rt = fr.number { min = 0, max = 1, doc = "kept share of the tangential velocity" },
    half_speed = fr.number { default = 9.144, above = 0, unit = "m/s", doc = "normal speed at which R_n is halved" },
    half_mass = fr.number { optional = true, above = 0, unit = "kg", doc = "mass at which R_n is halved; not scaled where it is left out" },
  },
  impact = function(p, contact)
    local v = contact.approach_speed / p.half_speed
    local m = p.half_mass and contact.mass / p.half_mass or 0
    return p.rn / (1 + v * v) / (1 + m * m), p.rt
  end,
}
