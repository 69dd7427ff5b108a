local fr = require "flyrock"

return fr.plugin {
  kind = "friction", name = "broken", doc = "A manifest with faults.",
  params = {
    mu = fr.number { default = -0.5, min = 0, doc = "below its own limit" },
    angle = fr.number { optional = true, unit = "dge", doc = "a unit that does not exist" },
  },
  fricton = function(p) return p.mu end,
}
