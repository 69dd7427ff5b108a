local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "throw",
  doc = "Speed that falls with the burden over the root of the charge per metre.",
  reads = { "blast.burden", "blast.hole.diameter", "blast.explosive.density if mode is face" },
  params = {
    k = fr.number { default = 13.5, above = 0, unit = "m/s", doc = "speed at a scaled burden of 1" },
    elevation = fr.number { default = 20, unit = "deg", doc = "above the outward horizontal" },
    mode = fr.choice { choices = { "face", "collar" }, default = "face", doc = "where it starts" },
  },
  launch = function(p, rock, blast, rng)
    local charge = math.pi / 4 * blast.hole_diameter ^ 2 * (blast.explosive_density or 800)
    local speed = p.k * (math.sqrt(charge) / blast.burden) * rng:uniform(0.9, 1.1)
    if p.mode == "collar" then speed = speed / 2 end
    return { velocity = rock:direction(speed, p.elevation), spin = rock.dimension == 2 and rng:normal() or { 0, 0, 1 } }
  end,
}
