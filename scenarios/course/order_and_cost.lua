-- Two balls of 1 kg fall 1 m and bounce without loss, one on a constraint (e = 1), one on a spring. By hand, on a constraint both
-- are at  y = 0.5 + v t - g t^2/2,  t = 1.2 s - sqrt(2/g),  v = sqrt(2 g):  1.0674726 m after 1.2 s.
-- Each row of the sweep is a method and a step h; the spring has 40 steps a period, k = m (2 pi/(40 h))^2.
--   exact    event-driven: a flight ends at the time of impact, and no step cuts it: the error of the ball on the constraint is rounding
--   stepped  Moreau and Jean: the impact belongs to a step of length h: order 1
--   the spring  holds the ball for half a period, 20 h: order 1, with a greater error
-- The steps are sqrt(2/g)/(100 2^k + 1/4), so that the impact falls on the same part of its step in each run.
local fr = require "flyrock"

local g = 9.81
local fall = math.sqrt(2 / g)
local at_end = 0.5 + math.sqrt(2 * g) * (1.2 - fall) - g / 2 * (1.2 - fall) ^ 2

local function row(flight, halvings)
  local step = fall / (100 * 2 ^ halvings + 0.25)
  return {
    ["solver.flight"] = flight,
    ["solver.time_step"] = step,
    ["materials.spring.unilateral.stiffness"] = (2 * math.pi / (40 * step)) ^ 2,
  }
end

local rows = { row("exact", 0), row("exact", 6) }
for halvings = 0, 6 do
  rows[#rows + 1] = row("stepped", halvings)
end

local function ball(material, x)
  return {
    name = material, material = material, shape = { type = "disk", radius = "0.5 m" }, mass = "1 kg", position = { x, 1.5 },
  }
end

return fr.scenario {
  flyrock = 1,
  title = "Order and cost: event-driven, Moreau and Jean, penalty",
  dimension = 2,
  method = "nscd",
  gravity = g,
  body_contacts = "off",
  terrain = { type = "profile", points = { { -5, 0 }, { 5, 0 } }, material = "constraint" },
  materials = {
    constraint = { restitution = { type = "newton", en = 1 } },
    spring = { unilateral = { type = "penalty", stiffness = "1000 N/m" } },
  },
  pairs = { { between = { "spring", "terrain" }, material = "spring" } },
  bodies = { ball("constraint", -1), ball("spring", 1) },
  solver = { time_step = "1 ms" },
  stop = { time = "1.2 s", speed = 0 },
  sweep = { rows = rows },
  expect = {
    { measure = "body.constraint.final.y", equals = at_end, tolerance = 1e-10, at = { ["solver.flight"] = "exact" } },
    {
      measure = "body.constraint.final.y", order_in = "solver.time_step", exact = at_end,
      between = { 0.99, 1.01 }, at = { ["solver.flight"] = "stepped" },
    },
    {
      measure = "body.spring.final.y", order_in = "solver.time_step", exact = at_end,
      between = { 0.95, 1 }, at = { ["solver.flight"] = "stepped" },
    },
  },
}
