local fr = require "flyrock"

return fr.scenario {
  flyrock = 1, dimension = 2, method = "nscd",
  terrain = { type = "benches", count = 1, height = "12 m", face_angle = 70, berm = "8 m", floor = "100 m",
    materials = { face = "rock", berm = "rock", floor = "rock" } },
  materials = {
    rock = { restitution = { type = "newton", en = 0.5 }, friction = { type = "coulomb", mu = 0.5 } },
  },
  rocks = {
    {
      name = "blocks", density = "2.7 g/cm3",
      shape = { type = "polygon", sides = 5, diameter = 0.5 },
      release = { from = "face", bench = 1 },
    },
  },
  stop = { time = "60 s" },
}
