local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "grip",
  doc = "Friction with a memory of the way that was slid.",
  history = { "way", "count" },
  history_of = "pair",
  params = {
    mu = fr.number { default = 0.6, min = 0, doc = "coefficient of a fresh contact" },
    length = fr.number { default = 1, above = 0, unit = "m", doc = "way over which it falls" },
    wet = fr.boolean { default = false, doc = "whether it has rained" },
  },
  friction = function(p, contact)
    local memory = contact.history
    memory.way = memory.way + contact.slip_speed * contact.step
    memory.count = memory.count + 1
    local mu = p.mu * math.exp(-memory.way / p.length)
    return mu, p.wet and mu / 2 or mu, 0, 0
  end,
}
