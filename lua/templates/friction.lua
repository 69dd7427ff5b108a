-- A friction law. Name this file in a scenario (`plugins: [friction.lua]`), and the law where it applies
-- (`friction: { type: my_friction, mu: 0.6 }`). `flyrock check friction.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "my_friction",
  doc = "Dry friction |r_t| <= mu r_n.",
  params = {
    mu = fr.number { default = 0.6, min = 0, doc = "coefficient of friction" },
  },
  -- Answers mu_s, and mu_d where sliding differs.
  friction = function(p, contact)
    return p.mu
  end,
}
