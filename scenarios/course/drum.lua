-- 48 grains with five corners in a drum that turns slowly. The slope of the grains rises with the drum until it fails: an avalanche takes it
-- down, and it rises again. The line from the axis to the mean place of the grains stands square to the slope, so its angle is that of the slope.
--   flyrock course drum --arg mu=0.3 --arg spin=2 --arg order=2
local fr = require "flyrock"
local grains, mu, spin, order = fr.argument("grains", 48), fr.argument("mu", 0.5), fr.argument("spin", 0.5), fr.argument("order", 1)
local drum_radius, radius, corners, columns, pitch = 0.5, 0.04, 5, 8, 0.1

-- The minimal standard generator of Park and Miller: other sizes and turns for each `order`.
local state = 7919 * order
local function draw()
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local bodies = {
  { name = "drum", shape = { type = "hollow_disk", radius = drum_radius }, material = "grain", position = { 0, 0 },
    driven = { velocity = { 0, 0 }, spin = spin } },
}
for i = 0, grains - 1 do
  local turn, size, vertices = 2 * math.pi * draw(), radius * (0.8 + 0.4 * draw()), {}
  for k = 1, corners do
    local angle = turn + 2 * math.pi * k / corners
    vertices[k] = { size * math.cos(angle), size * math.sin(angle) }
  end
  bodies[i + 2] = {
    name = "grain_" .. i + 1, shape = { type = "polygon", vertices = vertices }, density = 2500, material = "grain",
    position = { (i % columns - (columns - 1) / 2) * pitch, i // columns * pitch - 0.25 },
  }
end

return fr.scenario {
  flyrock = 1, title = "A drum turns slowly", dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { -5, -2 }, { 5, -2 } }, material = "grain" },
  materials = { grain = { friction = { type = "coulomb", mu = mu } } },
  bodies = bodies,
  settle = { ["until"] = "5 cm/s", at_most = "2 s" },
  stop = { time = "5 s", speed = 0 },
  output = { trajectories = { every = "0.05 s" }, series = { contacts = false, every = "0.05 s" } },
  expect = {
    { measure = "assembly.x.mean", between = { 0.1, 0.3 } },
    { measure = "assembly.y.mean", between = { -0.3, -0.1 } },
    { measure = "assembly.x.max", below = drum_radius },
    { measure = "assembly.y.min", above = -drum_radius },
    { measure = "solver.max_penetration", below = "1 mm" },
  },
}
