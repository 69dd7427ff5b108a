local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "coulomb",
  doc = "Dry friction |r_t| <= mu r_n, given by the coefficient or by the friction angle: mu = tan(angle).",
  source = "C. A. Coulomb 1785",
  params = {
    mu = fr.number { optional = true, min = 0, usual = { 0, 2 }, doc = "coefficient of friction; this or the angle" },
    angle = fr.number { optional = true, min = 0, below = 90, unit = "deg", usual = { 0, 63.5 }, doc = "friction angle; this or mu" },
  },
  native = "coulomb",
}
