-- Two semicircular arches of 21 voussoirs under their own weight. A thrust line fits into an arch that is thicker than
-- 0.1075 of its mean radius (Heyman; Cocchetti, Colasante and Rizzi 2011), and friction of 0.8 keeps it from sliding.
-- At 0.110 the arch stands; at 0.105 it opens hinges and comes down, slowly at first.
--   flyrock course arch --arg voussoirs=41 --arg thick=0.108 --arg thin=0.107
local fr = require "flyrock"

local voussoirs = fr.argument("voussoirs", 21)
local thick = fr.argument("thick", 0.110)  -- of the mean radius, the arch on the left
local thin = fr.argument("thin", 0.105)

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
add_arch(bodies, "thick", thick, 0)
add_arch(bodies, "thin", thin, 5)

local crown = voussoirs // 2 + 1  -- the middle stone
-- N; a stone has the area sin(pi/n) t R. A foot bears half of all stones, whatever the thrust is.
local stone_weight = 2700 * 9.81 * math.sin(math.pi / voussoirs) * thick

local expect = {
  { measure = ("body.thick_%d.max.speed"):format(crown), below = "1e-6 m/s" },
  { measure = "contact.thick_1.terrain.rn.mean", equals = voussoirs * stone_weight / 2, tolerance = 1e-3 },
  { measure = ("body.thin_%d.max.speed"):format(crown), above = "0.005 m/s" },
  { measure = "solver.not_converged", equals = 0, tolerance = 0 },
}
if voussoirs == 21 and thick == 0.110 then
  -- The lines of thrust that fit through the joints push the foot outwards with 1786.36 to 1827.28 N: 0.613 to 0.627 of
  -- (weight per metre) x R; 0.6209 is Heyman's arch at its limit.
  table.insert(expect, 3, { measure = "contact.thick_1.terrain.rt.at[0.05 s]", between = { -1827.28, -1786.36 } })
end

return fr.scenario {
  flyrock = 1,
  title = "Heyman's arch, above and below the limit of its thickness",
  dimension = 2,
  method = "nscd",
  terrain = { type = "plane", material = "stone" },
  materials = { stone = { friction = { type = "coulomb", mu = 0.8 } } },
  bodies = bodies,
  solver = { bodies = "exact" },  -- the thrust is read: dense steps of many stones are of first order
  stop = { time = "0.1 s", speed = 0 },
  output = { series = { bodies = { "thick_1" } } },
  expect = expect,
}
