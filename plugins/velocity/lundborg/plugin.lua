local fr = require "flyrock"

-- L / d^(2/3) in metres, d in inches: a crater blast throws 6.5 times as far as a bench blast.
local factor = { crater = 260, bench = 40 }
local g = 9.81  -- m/s2, where the distances were measured

return fr.plugin {
  kind = "velocity",
  name = "lundborg",
  doc = "Launch at sqrt(g L), g = 9.81 m/s2, of the greatest range in metres by the hole's diameter d in inches alone: "
    .. "L = 260 d^(2/3) of crater blasts, 40 d^(2/3) of bench blasts. It gives a distance, no speed: sqrt(g L) reaches L "
    .. "at 45 degrees on level ground without air.",
  source = "N. Lundborg, The probability of flyrock, SveDeFo 1981, and Lundborg et al. 1975, as given by McKenzie 2022",
  validity = "for screening, by the diameter alone: blasts with little stemming or burden are "
    .. "not told from others. The range is of the greatest throw in air: with drag, or at another angle, rocks land short of it, "
    .. "and the run says by how much. No distance for people: the farthest rock comes from the worst hole "
    .. "(docs/which-model.md).",
  reads = { "blast.hole.diameter" },
  params = {
    mode = fr.choice { choices = { "bench", "crater" }, default = "bench", doc = "which blasts" },
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal of the face (elsewhere +x)" },
  },
  launch = function(p, rock, blast)
    local inches = blast.hole_diameter / 0.0254
    local range = factor[p.mode] * inches ^ (2 / 3)
    return {
      velocity = rock:direction(math.sqrt(g * range), p.elevation),
      greatest_throw = range,
    }
  end,
}
