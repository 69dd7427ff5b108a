-- A launch model. Name this file in a scenario (`plugins: [velocity.lua]`), and the model in the `launch` of a group of rocks
-- (`launch: { type: my_launch, k: 13.5 m/s }`). `flyrock check velocity.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "velocity",
  name = "my_launch",
  doc = "Speed that falls with the burden over the root of the charge per metre, v = k (sqrt(W/l)/b)^1.3.",
  reads = { "blast.burden", "blast.hole.diameter", "blast.explosive.density" },
  params = {
    k = fr.number { default = 13.5, above = 0, unit = "m/s", doc = "speed at a scaled burden of 1" },
    elevation = fr.number { default = 45, unit = "deg", doc = "above the outward horizontal" },
  },
  -- `blast` has what `reads` names; each rock reads the hole that it leaves. Angles arrive in rad.
  launch = function(p, rock, blast, rng)
    local charge = math.pi / 4 * blast.hole_diameter ^ 2 * blast.explosive_density
    local speed = p.k * (math.sqrt(charge) / blast.burden) ^ 1.3
    return { velocity = rock:direction(speed, p.elevation) }
  end,
}
