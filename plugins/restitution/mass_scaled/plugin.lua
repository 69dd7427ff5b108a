local fr = require "flyrock"

-- A heavy block crushes the ground under it. Programs of rockfall practice offer to scale R_n by mass without printing how;
-- the function here is ours: Pfeiffer and Bowen's, with mass in the place of speed.
return fr.plugin {
  kind = "restitution",
  name = "mass_scaled",
  form = "newton",
  doc = "Normal restitution that falls with the mass of the rock: e_n = en / (1 + (mass / half_mass)^2).",
  source = "the option of rockfall programs to scale R_n by mass; the function is flyrock's, after Pfeiffer and Bowen 1989",
  reads = { "contact.mass" },
  params = {
    en = fr.number { default = 0.35, min = 0, max = 1, doc = "limit of a light rock" },
    half_mass = fr.number { above = 0, unit = "kg", doc = "mass at which e_n is halved" },
  },
  impact = function(p, contact)
    local r = contact.mass / p.half_mass
    return p.en / (1 + r * r)
  end,
}
