local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "penalty",
  doc = "A spring in place of a constraint, r_n = h k max(0, -g), as in smooth discrete elements: for comparison. It needs a "
    .. "step below 2 sqrt(m/k) to be stable and about a tenth of that to be accurate, and bodies overlap by m g / k at rest.",
  source = "P. A. Cundall and O. D. L. Strack, A discrete numerical model for granular assemblies, 1979",
  params = {
    stiffness = fr.number { above = 0, unit = "N/m", doc = "k of one contact" },
  },
  native = "penalty",
}
