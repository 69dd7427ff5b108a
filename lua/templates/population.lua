-- A population: which rocks a trial has. Name this file in a scenario (`plugins: [population.lua]`), and the population as the
-- `type` of a group in `rocks`. `flyrock check population.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "my_population",
  doc = "A number of rocks that differs from trial to trial, half of them heavier.",
  params = {
    most = fr.integer { default = 5, min = 1, max = 1000, doc = "greatest number of rocks" },
  },
  -- A list of rocks, each with its own values; {} takes everything from the group.
  rocks = function(p, terrain, blast, rng)
    local list = {}
    for i = 1, rng:integer(1, p.most) do list[i] = rng:uniform() < 0.5 and { density = 3000 } or {} end
    return list
  end,
}
