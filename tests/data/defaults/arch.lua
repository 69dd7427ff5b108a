-- A semicircular arch of 41 voussoirs, t/R 0.13 (Heyman's limit is 0.1075): it stands still.
local fr = require "flyrock"
local n, t, bodies = 41, 0.13, {}
for i = 0, n - 1 do
  local a, m, P = math.pi * i / n, math.pi * (i + 0.5) / n, {}
  local c, A, x, y = { math.cos(m), math.sin(m) }, 0, 0, 0
  for k, q in ipairs { { 1 - t/2, a }, { 1 + t/2, a }, { 1 + t/2, a + math.pi/n }, { 1 - t/2, a + math.pi/n } } do
    P[k] = { q[1] * math.cos(q[2]) - c[1], q[1] * math.sin(q[2]) - c[2] }
  end
  for k = 1, 4 do
    local p, q = P[k], P[k % 4 + 1]
    local z = p[1] * q[2] - q[1] * p[2]
    A, x, y = A + z/2, x + (p[1] + q[1]) * z/6, y + (p[2] + q[2]) * z/6
  end
  bodies[i + 1] = { name = ("v%d"):format(i), shape = { type = "polygon", vertices = P }, density = 2700, thickness = 1, material = "m", position = { c[1] + x/A, c[2] + y/A } }
end
return fr.scenario { flyrock = 1, dimension = 2, method = "nscd", terrain = { type = "plane", material = "m" }, bodies = bodies,
  materials = { m = { friction = { type = "coulomb", mu = 0.8 } } }, stop = { time = 0.5, speed = 0 },
  expect = { { measure = "body.v20.max.speed", below = "1e-6 m/s" } } }
