local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "heap",
  doc = "Disks and polygons above the first face.",
  params = { count = fr.integer { default = 3, min = 0, max = 50, doc = "of rocks" } },
  rocks = function(p, terrain, blast, rng)
    local rocks = {}
    for i = 1, p.count do
      local x = terrain.x_min + 1 + 2 * i
      rocks[i] = { radius = rng:uniform(0.2, 0.4), position = { x, terrain:height(x) + 2 }, angle = 0.1 * i }
    end
    return rocks
  end,
}
