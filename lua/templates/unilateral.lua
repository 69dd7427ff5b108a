-- A unilateral law: when a contact may be open or closed. Name this file in a scenario (`plugins: [unilateral.lua]`), and the
-- law where it applies (`unilateral: { type: my_condition, pull: 100 N }`). `flyrock check unilateral.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "my_condition",
  doc = "A contact that holds against a pull, 0 <= gap, r_n >= -pull, as clay sticks.",
  params = {
    pull = fr.number { default = 0, min = 0, unit = "N", doc = "greatest pull that it holds" },
  },
  -- "signorini", "quasi_shock", "cohesive" with a pull [N], or "penalty" with a stiffness [N/m].
  condition = function(p, contact)
    return "cohesive", p.pull
  end,
}
