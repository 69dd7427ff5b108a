local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "measured",
  doc = "One of a table of observed launch velocities (high-speed film, radar), each rock drawing one, all equally likely.",
  validity = "as far as the observations: rocks faster than the fastest that was seen are not drawn.",
  reads = {},
  params = {
    velocities = fr.points {
      unit = "m/s", doc = "observed [outward, upward] components, outward from the face (elsewhere +x)",
    },
    scale = fr.number { default = 1, above = 0, doc = "of all speeds: an error of the measurement, or another blast" },
  },
  launch = function(p, rock, _, rng)
    local seen = p.velocities[rng:integer(1, #p.velocities)]
    local speed = p.scale * math.sqrt(seen[1] ^ 2 + seen[2] ^ 2)
    return { velocity = rock:direction(speed, math.atan(seen[2], seen[1])) }
  end,
}
