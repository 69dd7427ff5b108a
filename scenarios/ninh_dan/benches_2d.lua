-- Fly-rock and loose rock of one bench blast in the limestone quarry of Ninh Dan: the plan of benches_2d.yaml,
-- and the same bytes in its tables. What is the paper's and what is assumed: README.md beside this file.
local fr = require "flyrock"

-- Both groups are rocks of the same face; they differ in what sets them off.
local function from_the_face(name, launch)
  launch.elevation = { normal = { mean = "20 deg", sd = "10 deg" } }
  return {
    name = name,
    per_trial = 1,
    density = "2.7 g/cm3",
    shape = {
      type = "polygon",
      sides = { integer = { 5, 9 } },
      diameter = { lognormal = { median = "0.6 m", log_sd = 0.35 } },
    },
    release = { from = "face", bench = 1 },
    launch = launch,
  }
end

return fr.scenario {
  flyrock = 1,
  title = "Ninh Dan limestone quarry, bench blast",
  dimension = 2,
  method = "nscd",
  seed = 2020,
  trials = 1000,

  terrain = {
    type = "benches",
    count = 3,
    height = "12 m",
    face_angle = "70 deg",
    berm = "8 m",
    floor = "400 m",
    materials = { face = "face_rock", berm = "broken_rock", floor = "haul_floor" },
  },

  materials = {
    face_rock = {
      restitution = { type = "newton", en = 0.6 },
      friction = { type = "coulomb", mu = 0.5 },
    },
    broken_rock = {
      restitution = { type = "newton", en = { uniform = { 0.3, 0.6 }, per = "impact" } },
      friction = { type = "coulomb", mu = 0.5 },
      rolling = { type = "rolling_resistance", mu_r = "0.05 m" },
    },
    haul_floor = {
      restitution = { type = "pfeiffer_bowen", en = 0.6 },
      friction = { type = "coulomb", angle = "33 deg" },
      rolling = { type = "rolling_resistance", mu_r = "0.03 m" },
    },
  },

  blast = {
    explosive = "ANFO",
    hole = {
      diameter = "102 mm",
      stemming = { uniform = { "2 m", "2.6 m" } },
      charge_length = { uniform = { "3 m", "6.5 m" } },
      subdrilling = { uniform = { "0.5 m", "0.8 m" } },
    },
    burden = { uniform = { "2.5 m", "2.9 m" } },
    spacing = "2.9 m",
    rows = { count = 3, distance = "3.2 m", holes = 8, delay_row = "42 ms", delay_hole = "17 ms" },
    rock_density = "2700 kg/m3",
    breakout_angle = "90 deg",
  },

  rocks = {
    -- Fly-rock: a block of the front row's burden at the greatest velocity that the face reaches. The burden as a whole is thrown
    -- far slower, and is not in this scenario; so its distances are those of fly-rock, not of the muck pile.
    from_the_face("fly_rock", { type = "bench_fit", rock = "limestone", form = "linear" }),
    -- Loose rock that the blast shakes out of the face: it falls and meets the berms.
    from_the_face("loose", { type = "fixed", speed = { uniform = { "2 m/s", "3 m/s" } } }),
  },

  stop = { time = "60 s" },
  output = { trajectories = { first = 100, every = "50 ms" } },  -- a parabola bends by 3 mm between two points

  expect = {
    { measure = "rocks.censored", below = 0.01 },
    { measure = "rocks.fly_rock.runout.p95", below = "280 m" },
  },
}
