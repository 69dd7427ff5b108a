local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "measured",
  doc = "One of a table of observed launch velocities (high-speed film, radar), each rock drawing one, all equally likely.",
  validity = "as far as the observations: rocks faster than the fastest that was seen are not drawn.",
  reads = {},
  params = {
    velocities = fr.points {
      unit = "m/s",
      doc = "observed components, outward from the face (elsewhere along +x): [outward, upward], in 3D [outward, to its left, upward]",
    },
    scale = fr.number { default = 1, above = 0, doc = "of all speeds: an error of the measurement, or another blast" },
  },
  launch = function(p, rock, _, rng)
    local seen, out = p.velocities[rng:integer(1, #p.velocities)], rock.outward
    if rock.dimension == 2 then return { velocity = { p.scale * seen[1] * out[1], p.scale * seen[2] } } end
    local outward, left, upward = seen[1], seen[2], seen[3]
    local x, y = outward * out[1] - left * out[2], outward * out[2] + left * out[1]
    return { velocity = { p.scale * x, p.scale * y, p.scale * upward } }
  end,
}
