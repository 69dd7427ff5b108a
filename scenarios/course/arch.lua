-- Two semicircular arches of 21 voussoirs under their own weight. A thrust line fits into an arch that is thicker than
-- 0.1075 of its mean radius (Heyman; Cocchetti, Colasante and Rizzi 2011), and friction of 0.8 keeps it from sliding.
-- At 0.110 the arch stands; at 0.105 it opens hinges and comes down, slowly at first.
local fr = require "flyrock"

local voussoirs = 21

--- The area and the centroid of a polygon.
local function middle(corners)
  local area, x, y = 0, 0, 0
  for k, p in ipairs(corners) do
    local q = corners[k % #corners + 1]
    local z = p[1] * q[2] - q[1] * p[2]
    area, x, y = area + z / 2, x + (p[1] + q[1]) * z / 6, y + (p[2] + q[2]) * z / 6
  end
  return x / area, y / area
end

--- The voussoirs of an arch of mean radius 1 m about (x_0, 0).
local function add_arch(bodies, name, thickness, x_0)
  for i = 0, voussoirs - 1 do
    local from, to = math.pi * i / voussoirs, math.pi * (i + 1) / voussoirs
    local inner, outer = 1 - thickness / 2, 1 + thickness / 2
    local corners = {
      { inner * math.cos(from), inner * math.sin(from) }, { outer * math.cos(from), outer * math.sin(from) },
      { outer * math.cos(to), outer * math.sin(to) }, { inner * math.cos(to), inner * math.sin(to) },
    }
    local x, y = middle(corners)
    for _, corner in ipairs(corners) do corner[1], corner[2] = corner[1] - x, corner[2] - y end
    bodies[#bodies + 1] = {
      name = ("%s_%d"):format(name, i + 1), shape = { type = "polygon", vertices = corners },
      density = "2700 kg/m3", thickness = "1 m", material = "stone", position = { x_0 + x, y },
    }
  end
end

local bodies = {}
add_arch(bodies, "thick", 0.110, 0)
add_arch(bodies, "thin", 0.105, 5)

return fr.scenario {
  flyrock = 1,
  title = "Heyman's arch, above and below the limit of its thickness",
  dimension = 2,
  method = "nscd",
  terrain = { type = "plane", material = "stone" },
  materials = { stone = { friction = { type = "coulomb", mu = 0.8 } } },
  bodies = bodies,
  stop = { time = "0.1 s", speed = 0 },
  output = { series = { bodies = { "thick_1" } } },
  expect = {
    { measure = "body.thick_11.max.speed", below = "1e-6 m/s" },
    -- The foot bears half the weight of 21 stones of 217.1 N. The lines of thrust that fit through the joints push it
    -- outwards with 1786.36 to 1827.28 N: 0.613 to 0.627 of (weight per metre) x R; 0.6218 is Heyman's arch at its limit.
    { measure = "contact.thick_1.terrain.rn.mean", equals = 4559.5733, tolerance = 1e-3 },
    { measure = "contact.thick_1.terrain.rt.at[0.05 s]", between = { -1827.28, -1786.36 } },
    { measure = "body.thin_11.max.speed", above = "0.005 m/s" },
    { measure = "solver.not_converged", equals = 0, tolerance = 0 },
  },
}
