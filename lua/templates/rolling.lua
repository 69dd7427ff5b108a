-- A rolling resistance. Name this file in a scenario (`plugins: [rolling.lua]`), and the law where it applies
-- (`rolling: { type: my_rolling, share: 0.05 }`). `flyrock check rolling.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "rolling",
  name = "my_rolling",
  doc = "Rolling resistance whose arm is a share of the radius of the rock.",
  params = {
    share = fr.number { default = 0.05, min = 0, doc = "arm mu_r over the radius" },
  },
  -- Answers mu_r [m], and in 3D mu_spin [m].
  rolling = function(p, contact)
    return p.share * contact.radius
  end,
}
