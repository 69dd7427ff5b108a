local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "slip_weakening",
  doc = "Coulomb friction that falls linearly from mu_s to mu_d over a distance of slip, and stays there: "
    .. "mu = mu_s - (mu_s - mu_d) min(slip / distance, 1). The slip of each contact is remembered.",
  source = "Y. Ida, Cohesive force across the tip of a longitudinal-shear crack, 1972",
  reads = { "contact.slip_speed", "contact.step", "contact.was_sticking" },
  history = { "slip" },
  history_of = "contact",
  params = {
    mu_s = fr.number { min = 0, usual = { 0, 2 }, doc = "coefficient before any slip" },
    mu_d = fr.number { min = 0, max = "mu_s", usual = { 0, 2 }, doc = "coefficient after the distance" },
    distance = fr.number { above = 0, unit = "m", doc = "slip over which friction falls" },
  },
  native = "slip_weakening",
}
