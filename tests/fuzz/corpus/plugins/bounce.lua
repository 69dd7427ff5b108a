local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "bounce",
  form = "newton",
  doc = "Restitution that falls with the mass of the block.",
  params = {
    en = fr.number { default = 0.6, min = 0, max = 1, doc = "of a light block" },
    exponent = fr.number { default = 0.1, min = 0, doc = "how fast it falls" },
    mass = fr.number { default = 100, above = 0, unit = "kg", doc = "mass up to which it does not fall" },
  },
  impact = function(p, contact)
    local ratio = math.max(contact.mass / p.mass, 1)
    return p.en * ratio ^ -p.exponent, 0
  end,
}
