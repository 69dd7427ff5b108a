local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "newton",
  form = "newton",
  doc = "Constant coefficients of restitution: v_n+ = -e_n v_n-, v_t+ = -e_t v_t- where the contact sticks. "
    .. "May gain energy where slip stops or reverses; each gain is counted.",
  source = "M. Jean, The non-smooth contact dynamics method, 1999",
  params = {
    en = fr.number { min = 0, doc = "normal restitution" },
    et = fr.number { default = 0, min = -1, max = 1, doc = "tangential restitution" },
  },
  native = "newton",
}
