local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "pneumatic_hollow_disk",
  doc = "A hollow disk whose inner radius R is a degree of freedom (2D): `pneumatic_disk` touched from inside only, where contacts push "
    .. "the radius out. J = m R^2; its outer radius is 1.05 R.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 20 }, doc = "inner radius, at the start and at the pressure that is given" },
    pressure = fr.number { min = 0, unit = "Pa", doc = "absolute pressure of the gas at this radius" },
    outside = fr.number { default = 101325, min = 0, unit = "Pa", doc = "pressure of the air outside" },
    gamma = fr.number { default = 1.4, min = 0, usual = { 0, 1.67 }, doc = "p = pressure (radius/R)^(2 gamma); 0: constant pressure, 1: constant temperature" },
    stiffness = fr.number { default = 0, min = 0, unit = "N/m", doc = "of the ring: the force along the radius for a change of it by 1 m" },
    damping = fr.number { default = 0, min = 0, unit = "N s/m", doc = "of the ring: the force along the radius for a rate of 1 m/s" },
    radial_mass = fr.number { optional = true, above = 0, unit = "kg", doc = "mass that moves with the radius; the mass where it is left out" },
  },
  native = "pneumatic_hollow_disk",
}
