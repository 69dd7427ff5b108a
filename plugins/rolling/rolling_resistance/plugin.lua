local fr = require "flyrock"

return fr.plugin {
  kind = "rolling",
  name = "rolling_resistance",
  doc = "A torque against rolling, bounded by the normal reaction: |m_r| <= mu_r r_n. A disk of radius R that "
    .. "rolls on level ground loses speed at mu_r g / (R (1 + I/(m R^2))).",
  source = "V. Acary and F. Bourrier, Coulomb friction with rolling resistance as a cone complementarity problem, 2021",
  params = {
    mu_r = fr.number { min = 0, unit = "m", doc = "bound of the torque over the normal reaction" },
    mu_spin = fr.number { default = 0, min = 0, unit = "m", doc = "the same for the torque about the normal; acts in 3D" },
  },
  native = "rolling_resistance",
}
