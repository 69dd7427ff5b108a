-- A wall of a hundred bricks stands still, up to the residual of dense steps: 1e-4 of g x 4 ms.
local fr = require "flyrock"
local bodies = {}
for k = 0, 99 do
  local row, i = k // 10, k % 10
  bodies[k+1] = { name = ("b%d"):format(k), shape = { type = "polygon", vertices = {{-.5,-.25},{.5,-.25},{.5,.25},{-.5,.25}} }, density = 1350, thickness = 1, material = "m",
    position = { 1.01 * i + (row % 2 == 1 and 0.25 or 0), 0.25 + 0.5 * row } }
end
return fr.scenario { flyrock = 1, dimension = 2, method = "nscd", terrain = { type = "plane", material = "m" }, bodies = bodies,
  materials = { m = { friction = { type = "coulomb", mu = 0.6 } } }, stop = { time = 1, speed = 0 },
  expect = { { measure = "body.b95.max.speed", below = "4e-6 m/s" } } }
