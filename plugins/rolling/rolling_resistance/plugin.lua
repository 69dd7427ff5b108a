local fr = require "flyrock"

return fr.plugin {
  kind = "rolling",
  name = "rolling_resistance",
  doc = "A torque against rolling, bounded by the normal reaction: |m_r| <= mu_r r_n. A disk of radius R that "
    .. "rolls on level ground loses speed at mu_r g / (R (1 + I/(m R^2))). In 3D |m_n| <= mu_spin r_n bounds the "
    .. "torque about the normal too; a sphere loses its spin at 5 mu_spin g / (2 R^2). Ground that resists rolling "
    .. "resists pivoting: the default of mu_spin is what a patch with a friction of 0.25 bears at least.",
  source = "V. Acary and F. Bourrier, Coulomb friction with rolling resistance as a cone complementarity problem, 2021",
  reads = { "contact.radius" },
  params = {
    mu_r = fr.number { optional = true, min = 0, unit = "m", doc = "bound of the torque over the normal reaction; this or share" },
    share = fr.number { optional = true, min = 0, usual = { 0, 1 }, doc = "the same as a share of the radius of the sphere (2D: disk) "
      .. "of equal volume; this or mu_r. The steepest slope that holds a sphere has this tangent" },
    mu_spin = fr.number { optional = true, min = 0, unit = "m", doc = "the same for the torque about the normal; acts in 3D; "
      .. "2/5 of mu_r where it is left out" },
  },
  native = "rolling_resistance",
}
