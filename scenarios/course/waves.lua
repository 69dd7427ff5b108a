-- Rows of 3, 10 and 40 equal balls that touch, on Hertz's springs: F = A d^(3/2), with the overlap d of two balls. The first
-- ball of each row comes with 1 m/s. Balls of 1 kg, 0.1 m from centre to centre (D), A = 1e9 N/m^1.5, no friction and no damper.
--   3 balls: an ordinary differential equation of six numbers, integrated by hand: -0.07095, 0.07640, 0.99455 m/s.
--   Long rows: a solitary wave forms, in which each ball has its greatest speed v after the one before it. Its speed is, for
--   waves much longer than a ball (Nesterenko 1983),
--     V = (16/25)^(1/5) D (A/m)^(2/5) v^(1/5) = 337.25 m/s  at v = 0.68163 m/s,
--   and 334.60 m/s by the equations of the row, whose wave is only five balls long. The last ball takes nearly all.
local fr = require "flyrock"

local diameter = 0.1
local exponent = fr.argument("exponent", 1.5)
local stiffness = fr.argument("stiffness", 1e9) -- N/m^exponent
local bodies = {}

--- Adds a row of touching balls along x, the first of which moves.
local function add_row(name, count, y)
  for i = 1, count do
    bodies[#bodies + 1] = {
      name = name .. "_" .. i, material = "steel", mass = "1 kg",
      shape = { type = "disk", radius = diameter / 2 },
      position = { (i - 1) * diameter, y },
      velocity = { i == 1 and 1 or 0, 0 },
    }
  end
end

add_row("three", 3, 0.6)
add_row("ten", 10, 0.4)
add_row("forty", 40, 0.2)

return fr.scenario {
  flyrock = 1,
  title = "Waves through balls that touch",
  dimension = 2,
  method = "nscd",
  gravity = 0,
  terrain = { type = "profile", points = { { -5, 0 }, { 10, 0 } }, material = "steel" },
  materials = { steel = { unilateral = { type = "penalty", stiffness = stiffness, exponent = exponent } } },
  bodies = bodies,
  solver = { time_step = "5 us" },
  stop = { time = "14 ms", speed = 0 },
  output = { series = { every = "140 us" } },
  expect = {
    { measure = "body.three_1.final.vx", equals = -0.070952, tolerance = 1e-4 },
    { measure = "body.three_2.final.vx", equals = 0.076403, tolerance = 1e-4 },
    { measure = "body.three_3.final.vx", equals = 0.994549, tolerance = 1e-4 },
    { measure = "body.ten_10.final.vx", equals = 0.985866, tolerance = 1e-4 },
    { measure = "body.forty_40.final.vx", equals = 0.985679, tolerance = 1e-4 },
    { measure = "body.forty_1.final.vx", equals = -0.071085, tolerance = 1e-4 },
    -- The speed of a ball in the wave, and from the last ball's place when the wave arrives at the end
    { measure = "body.forty_25.max.vx", equals = 0.681632, tolerance = 1e-4 },
    { measure = "body.forty_40.final.x", equals = 3.9023042, tolerance = 1e-5 },
  },
}
