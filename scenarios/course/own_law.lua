-- A restitution law of one's own: e = en up to 1 m/s, beyond it en v^(-1/5), as metal that yields. A ball falls 10 m: each
-- approach at v gives the next one, v' = 0.8 v^(4/5), and an apex of v'^2/(2 g).
local fr = require "flyrock"

fr.plugin {
  kind = "restitution",
  name = "softening",
  doc = "Newton's law with a coefficient that falls with the speed of approach.",
  params = {
    en = fr.number { default = 0.8, min = 0, max = 1, doc = "coefficient up to 1 m/s" },
    power = fr.number { default = 0.2, min = 0, max = 1, doc = "how fast it falls" },
  },
  impact = function(p, contact)
    return p.en * math.max(contact.approach_speed, 1) ^ -p.power, 0
  end,
}

return fr.scenario {
  flyrock = 1,
  title = "A restitution law of one's own",
  dimension = 2,
  method = "nscd",
  terrain = { type = "profile", points = { { -5, 0 }, { 5, 0 } }, material = "floor" },
  materials = { floor = { restitution = { type = "softening" } } },
  bodies = {
    { name = "ball", shape = { type = "disk", radius = "0.1 m" }, mass = "1 kg", position = { 0, 10.1 } },
  },
  stop = { time = "5 s" },
  expect = {
    { measure = "body.ball.impact[1].vn_after", equals = 6.609515, tolerance = 1e-5 },
    { measure = "body.ball.apex[1].height", equals = 2.226590, tolerance = 1e-5 },
    { measure = "body.ball.apex[2].height", equals = 0.669503, tolerance = 1e-5 },
    { measure = "body.ball.apex[3].height", equals = 0.256001, tolerance = 1e-5 },
  },
}
