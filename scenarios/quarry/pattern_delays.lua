-- A blast of three rows of eight holes: each rock belongs to a hole, has its hole's burden and stemming, and leaves when its
-- hole goes off, 17 ms after its neighbour and 42 ms after the row in front. Rigid blocks over three benches.
-- A delay moves the clock of a rock, nothing else: rocks that do not meet each other come to rest at the same places.
local fr = require "flyrock"

local holes, rows = 8, 3

local function group(name, from, launch)
  return {
    name = name,
    per_trial = rows * holes,  -- one a hole
    density = "2.7 g/cm3",
    shape = { type = "polygon", sides = { integer = { 5, 9 } }, diameter = { lognormal = { median = "0.4 m", log_sd = 0.35 } } },
    release = { from = from },
    launch = launch,
  }
end

return fr.scenario {
  flyrock = 1,
  title = "Three rows of eight holes with delays",
  dimension = 2,
  method = "nscd",
  seed = 24,
  trials = 50,
  terrain = {
    type = "benches", count = 2, height = "10 m", face_angle = "70 deg", berm = "10 m", floor = "500 m", material = "rock",
  },
  materials = {
    rock = {
      restitution = { type = "newton", en = { uniform = { 0.3, 0.6 }, per = "impact" } },
      friction = { type = "coulomb", mu = 0.5 },
      rolling = { type = "rolling_resistance", mu_r = "0.05 m" },
    },
  },
  blast = {
    explosive = "ANFO",
    hole = { diameter = "102 mm", length = "10.6 m", stemming = { uniform = { "2 m", "2.6 m" } }, subdrilling = "0.6 m" },
    burden = { uniform = { "2.5 m", "2.9 m" } },
    spacing = "3.2 m",
    rows = { count = rows, distance = "3.2 m", holes = holes, delay_row = "42 ms", delay_hole = "17 ms", delay_in_hole = "400 ms" },
    rock_density = "2700 kg/m3",
    breakout_angle = "90 deg",
  },
  rocks = {
    group("face", "face", { type = "bench_fit", rock = "limestone", elevation = { normal = { mean = "20 deg", sd = "10 deg" } } }),
    group("top", "bench_top", { type = "richards_moore", mode = "cratering", k = 14 }),  -- k of the site: put yours
  },
  gates = { { name = "road", x = "150 m" } },
  stop = { time = "60 s" },
  output = { trajectories = { first = 2, every = "20 ms" } },
  expect = { { measure = "rocks.censored", below = 0.02 } },
}
