local fr = require "flyrock"

return fr.plugin {
  kind = "restitution",
  name = "bounded",
  doc = "Two speeds, of which one is below the other.",
  params = {
    slow = fr.number { default = 18, min = 0, below = "fast", unit = "km/h", doc = "below it all of the speed is kept" },
    fast = fr.number { default = 7, unit = "m/s", doc = "from it on nothing is kept" },
  },
  impact = function(p, contact) return math.max(0, math.min(1, (p.fast - contact.approach_speed) / (p.fast - p.slow))) end,
}
