local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "penalty",
  doc = "A spring and a damper in place of a constraint, as in smooth discrete elements: with the overlap d, F = k d^n + "
    .. "c d^(n-1) d', never a pull. The friction of the material bounds the tangential force: by Coulomb's law on the slip, or "
    .. "by a tangential spring F_t = k_t s that slides at mu F. Bodies overlap, by m g / k at rest on one contact with n = 1. "
    .. "Chosen steps (`time_step: auto`) follow the spring; a fixed step must be below 2 sqrt(m/k) to be stable (below 2 c/k "
    .. "where c > 2 sqrt(k m)), and about a tenth of that to be accurate. The law of restitution of the material is not used: only the damper takes energy.",
  source = "n = 1, c: Kelvin and Voigt; n = 1.5: H. Hertz, 1881; k_t: P. A. Cundall and O. D. L. Strack, A discrete numerical "
    .. "model for granular assemblies, 1979",
  params = {
    stiffness = fr.number { above = 0, unit = "N/m^exponent", doc = "k of one contact: the force at an overlap of 1 m" },
    damping = fr.number { min = 0, default = 0, unit = "N s/m^exponent",
      doc = "c of one contact; a ball that bounces on a linear spring keeps e = exp(-z w t) of its speed with z = c / (2 sqrt(k m)), "
        .. "w = sqrt(k/m), w t sqrt(1 - z^2) = pi - atan2(2 z sqrt(1 - z^2), 1 - 2 z^2); z = 0.2 gives e = 0.57" },
    exponent = fr.number { min = 1, max = 1.5, default = 1, doc = "n: 1 linear, 1.5 two round bodies (Hertz)" },
    tangential_stiffness = fr.number { min = 0, default = 0, unit = "N/m", doc = "k_t of one contact; 0: Coulomb's law on the slip" },
  },
  native = "penalty",
}
