local fr = require "flyrock"

return fr.plugin {
  kind = "rolling",
  name = "roll",
  doc = "Rolling resistance in proportion to the radius.",
  params = { ratio = fr.number { default = 0.1, min = 0, doc = "mu_r over the radius" } },
  rolling = function(p, contact) return p.ratio * contact.radius, 0 end,
}
