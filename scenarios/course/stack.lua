-- Two stacks of bricks that lean out over the edge of a table. Of n bricks the top one may reach out by (1 + 1/2 + ... + 1/n)/2 of its length beyond the
-- table: each lies with the middle of all above it, and its own, over the edge below. One stack keeps to 0.98 of that, the other goes to 1.02.
--   flyrock course stack --arg bricks=8 --arg bold=1.005
local fr = require "flyrock"
local bricks, careful, bold = fr.argument("bricks", 5), fr.argument("careful", 0.98), fr.argument("bold", 1.02)
local length, height = 1, 0.25  -- m

local bodies, reach = {}, 0
for k = 1, bricks do reach = reach + 1 / (2 * k) end

--- A stack on a table whose edge is at x_0; brick 1 is the top one.
local function add_stack(name, share, x_0)
  bodies[#bodies + 1] = {
    name = name .. "_table", shape = { type = "polygon", vertices = { { -1, -0.5 }, { 1, -0.5 }, { 1, 0.5 }, { -1, 0.5 } } },
    material = "brick", position = { x_0 - 1, 1.5 }, fixed = true,
  }
  local x = x_0 - length / 2
  for k = bricks, 1, -1 do
    x = x + share * length / (2 * k)
    bodies[#bodies + 1] = {
      name = name .. "_" .. k, density = 1800, material = "brick", position = { x, 2 + height * (bricks - k + 0.5) },
      shape = { type = "polygon", vertices = { { -length / 2, -height / 2 }, { length / 2, -height / 2 }, { length / 2, height / 2 }, { -length / 2, height / 2 } } },
    }
  end
  return x
end
local top = add_stack("careful", careful, -1)
add_stack("bold", bold, 5)

return fr.scenario {
  flyrock = 1, title = "Stacks that lean out", dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { -6, 0 }, { 12, 0 } }, material = "brick" },
  materials = { brick = { friction = { type = "coulomb", mu = 0.6 } } },
  bodies = bodies,
  stop = { time = "4 s" },
  output = { trajectories = { every = "0.02 s" } },
  expect = {
    { measure = "body.careful_1.final.x", equals = top, tolerance = 1e-6 },
    { measure = "body.careful_1.final.y", equals = 2 + height * (bricks - 0.5), tolerance = 1e-6 },
    { measure = "body.bold_1.final.y", below = 1 },
    { measure = "energy.total.relative_change", below = 1e-9 },
  },
}
