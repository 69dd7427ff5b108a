-- The loads of loads.yaml as functions.
local fr = require "flyrock"
local brick = { type = "polygon", vertices = { { -0.2, -0.1 }, { 0.2, -0.1 }, { 0.2, 0.1 }, { -0.2, 0.1 } } }
return fr.scenario {
  flyrock = 1, dimension = 2, method = "nscd",
  gravity = fr.over_time(function() return 9.81 end),
  terrain = { type = "profile", points = { { -50, 50 }, { 0, 0 }, { 50, 0 } }, material = "rock" },
  materials = { rock = { friction = { type = "coulomb", mu = fr.over_time(function(t) return 1.2 - 0.2 * t end) } } },
  bodies = {
    { name = "on_slope", shape = brick, mass = 40, material = "rock", position = { -19.929289321881345, 20.070710678118655 }, orientation = "-45 deg" },
    { name = "pushed", shape = brick, mass = 40, material = "rock", position = { 0, 45 }, force = fr.over_time(function(t) return { 40 * t, 0 } end) },
    { name = "lift", shape = brick, material = "rock", position = { 10, 30 },
      driven = { velocity = fr.over_time(function(t) return { math.min(2 * t, 2), t < 1 and t or 2 * t - 1 } end) } },
  },
  stop = { time = "2 s", speed = 0 },
}
