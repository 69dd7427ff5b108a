local fr = require "flyrock"

local law = fr.plugin {
  kind = "restitution", name = "soft", doc = "A law of this scenario.",
  impact = function(p, contact) return 0.1 end,
}

return fr.scenario {
  flyrock = 1, dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { 0, 0 }, { 10, 0 } }, material = "rock" },
  materials = { rock = { restitution = { type = law } } },
  rocks = { { name = "a", density = 2700, shape = { type = "disk", radius = 0.1 }, release = { position = { 5, 1 } } } },
  stop = { time = 1 },
}
