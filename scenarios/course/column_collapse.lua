-- A column of disks between two walls on a rough base. One wall goes, the column collapses, and the disks come to rest. Lube, Huppert, Sparks and
-- Freundt (2005) let columns of grains collapse in a channel: of a column of length L_0 and height a L_0 the front comes to rest at L with
-- (L - L_0)/L_0 = 1.2 a up to a = 2.3, and 1.9 a^(2/3) beyond.
--   flyrock course column_collapse --arg a=4 --arg order=2
local fr = require "flyrock"
local grains, a, mu, order = fr.argument("grains", 120), fr.argument("a", 2), fr.argument("mu", 0.5), fr.argument("order", 1)
local radius, spread = 0.01, 0.2  -- m; sizes are even within 20 % of it
local filled = 0.74               -- share of the column that is grains, when they have settled

-- The minimal standard generator of Park and Miller: other sizes for each `order`.
local state = 7919 * order
local function draw()
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local length = math.sqrt(grains * math.pi * radius ^ 2 / (filled * a))  -- L_0
local expected = length * (1 + (a < 2.3 and 1.2 * a or 1.9 * a ^ (2 / 3)))

-- The base has teeth of the pitch of a grain, so that no grain rolls away on it.
local teeth = {}
for i = -6, math.ceil(3 * expected / radius) do teeth[#teeth + 1] = { i * radius, i % 2 == 0 and 0 or -radius / 2 } end

local height, thick = 1.7 * a * length + 4 * radius, 4 * radius
local function wall(name, x)
  local corners = { { -thick / 2, 0 }, { thick / 2, 0 }, { thick / 2, height }, { -thick / 2, height } }
  return { name = name, shape = { type = "polygon", vertices = corners }, material = "grain", position = { x, height / 2 } }
end
local back, gate = wall("back", -thick / 2), wall("gate", length + thick / 2)
back.fixed = true
-- The gate goes faster than what is behind it, and stops where nothing comes.
local quick = 20  -- m/s2
local half = math.sqrt(1.5 * expected / quick)
gate.driven = { velocity = { table = { { 0, { 0, 0 } }, { half, { quick * half, 0 } }, { 2 * half, { 0, 0 } } } } }
local bodies = { back, gate }

local columns, pitch = math.floor(length / (2.05 * radius * (1 + spread))), 2.05 * radius * (1 + spread)
for i = 0, grains - 1 do
  bodies[#bodies + 1] = {
    name = "grain_" .. i + 1, shape = { type = "disk", radius = radius * (1 - spread + 2 * spread * draw()) }, density = 2500,
    material = "grain", position = { (i % columns + 0.5) * length / columns, i // columns * pitch + 1.3 * radius },
  }
end

return fr.scenario {
  flyrock = 1, title = "A column collapses", dimension = 2, method = "nscd",
  terrain = { type = "profile", points = teeth, material = "grain" },
  materials = { grain = { friction = { type = "coulomb", mu = mu } } },
  bodies = bodies,
  settle = { ["until"] = "1 cm/s", at_most = "2 s" },
  stop = { time = "2 s" },
  output = { trajectories = { every = "0.02 s" } },
  expect = {
    { measure = "assembly.x.max", between = { 0.8 * expected, 1.35 * expected } },
    { measure = "assembly.kinetic_energy.max", below = 1e-5 },
    { measure = "assembly.x.min", above = 0 },
    { measure = "solver.max_penetration", below = radius / 100 },
  },
}
