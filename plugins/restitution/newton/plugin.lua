local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "newton",
  form = "newton",
  doc = "Constant coefficient of restitution e, read by one of four forms: newton, v_n+ = -e v_n- (may gain energy where slip "
    .. "stops or reverses; each gain is counted); newton_mean, the same with friction on the mean of the tangential "
    .. "velocities before and after; poisson, e times the normal impulse; energy, e^2 times the normal work (Stronge).",
  source = "M. Jean, The non-smooth contact dynamics method, 1999; M. Fremond 1995; S. D. Poisson 1811; W. J. Stronge 1990",
  params = {
    en = fr.number { min = 0, max = 1, doc = "coefficient of restitution" },
    et = fr.number { optional = true, min = -1, max = 1, doc = "tangential restitution v_t+ = -e_t v_t- of a contact that sticks; form newton only" },
    form = fr.choice { choices = { "newton", "newton_mean", "poisson", "energy" }, default = "newton", doc = "what the coefficient means" },
    as_lmgc90 = fr.boolean {
      optional = true,
      doc = "also a contact that separates keeps to v_n+ >= -e v_n-, as in LMGC90's RST_CLB; form newton only",
    },
  },
  native = "newton",
}
