-- A stack of ten boxes stands still.
local fr = require "flyrock"
local bodies = {}
for i = 1, 10 do
  bodies[i] = { name = ("b%d"):format(i), shape = { type = "polygon", vertices = {{-.5,-.5},{.5,-.5},{.5,.5},{-.5,.5}} }, density = 2700, thickness = 1, material = "m", position = { 0, i - 0.5 } }
end
return fr.scenario { flyrock = 1, dimension = 2, method = "nscd", terrain = { type = "plane", material = "m" }, bodies = bodies,
  materials = { m = { friction = { type = "coulomb", mu = 0.6 } } }, stop = { time = 2, speed = 0 },
  expect = { { measure = "body.b10.max.speed", below = "1e-6 m/s" } } }
