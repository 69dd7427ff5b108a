-- A muck pile in section: blocks of a blast fall in front of a bench and come to rest. Other runs may start in the pile, with `start: { from: DIR }` in a
-- scenario of the same blocks: a rock falls on it, the ground shakes, a shovel takes its toe away. 300 blocks take four times as long as 200.
--   flyrock run scenarios/quarry/muck_pile.lua --arg blocks=300 -o out/pile
local fr = require "flyrock"
local blocks, order = fr.argument("blocks", 200), fr.argument("order", 1)
local columns, pitch, corners = 15, 1.1, 6  -- m

-- The minimal standard generator of Park and Miller: other blocks for each `order`.
local state = 7919 * order
local function draw()
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local bodies = {}
for i = 0, blocks - 1 do
  local turn, size, vertices = 2 * math.pi * draw(), 0.25 + 0.25 * draw(), {}
  for k = 1, corners do
    local angle = turn + 2 * math.pi * (k + 0.4 * draw()) / corners
    vertices[k] = { size * math.cos(angle), size * math.sin(angle) }
  end
  bodies[i + 1] = {
    name = "block_" .. i + 1, shape = { type = "polygon", vertices = vertices }, density = "2650 kg/m3", material = "rock",
    position = { 4 + (i % columns) * pitch, 0.6 + i // columns * pitch },
  }
end

return fr.scenario {
  flyrock = 1, title = "A muck pile, in section", dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { -6, 12 }, { 0, 12 }, { 3, 0 }, { 50, 0 } }, material = "rock" },
  materials = { rock = { restitution = { type = "newton", en = 0.2 }, friction = { type = "coulomb", mu = 0.6 } } },
  bodies = bodies,
  stop = { time = "12 s" },
  output = { trajectories = { every = "0.1 s" } },
  expect = {
    { measure = "assembly.at_rest", equals = blocks, tolerance = 0.01 * blocks },
    { measure = "assembly.y.max", between = { 2, 12 } },
    { measure = "solver.max_penetration", below = "5 mm" },
  },
}
