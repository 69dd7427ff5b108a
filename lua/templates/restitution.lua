-- A restitution law. Name this file in a scenario (`plugins: [restitution.lua]`), and the law where it applies
-- (`restitution: { type: my_restitution, en: 0.5 }`). `flyrock check restitution.lua` tries it, `flyrock law` draws it.
local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "my_restitution",
  doc = "Newton's law: the normal velocity returns with the factor -e_n.",
  form = "newton",
  params = {
    en = fr.number { default = 0.5, min = 0, max = 1, doc = "normal restitution" },
  },
  -- contact.vn is the normal approach [m/s], contact.mass the mass [kg]; docs/writing-a-plugin.md lists the rest.
  impact = function(p, contact)
    return p.en, 0
  end,
}
