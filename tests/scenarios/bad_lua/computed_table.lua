local fr = require "flyrock"

-- What a program computes has no place of its own: messages point to the call.
local function stop(time) return { time = time } end

local scenario = {
  flyrock = 1, dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { 0, 0 }, { 10, 0 } }, material = "rock" },
  materials = { rock = {} },
  rocks = { { name = "a", density = 2700, shape = { type = "disk", radius = 0.1 }, release = { position = { 5, 1 } } } },
  stop = stop("60 m"),
}
return fr.scenario(scenario)
