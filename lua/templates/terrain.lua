-- A terrain. Name this file in a scenario (`plugins: [terrain.lua]`), and the terrain as its `type`
-- (`terrain: { type: my_terrain, drop: 20 m, material: rock }`). `flyrock check terrain.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "my_terrain",
  dimension = 2,
  doc = "A level, a slope of 45 degrees and a level.",
  params = {
    drop = fr.number { default = 20, above = 0, unit = "m", doc = "height of the slope" },
  },
  -- The corners of the profile from left to right. In 3D vertices and triangles, or heights.
  build = function(p, rng, dimension)
    return { points = { { -20, p.drop }, { 0, p.drop }, { p.drop, 0 }, { p.drop + 200, 0 } } }
  end,
}
