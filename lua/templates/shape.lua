-- A shape. Name this file in a scenario (`plugins: [shape.lua]`), and the shape in a group of rocks
-- (`shape: { type: my_shape, size: 0.5 m }`). `flyrock check shape.lua` tries it.
local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "my_shape",
  doc = "A slab twice as long as high; in 3D of square plan.",
  params = {
    size = fr.number { default = 0.5, above = 0, unit = "m", doc = "its length" },
  },
  -- Corners of a convex body in its own frame, or { radius = r }; rng draws random numbers.
  build = function(p, rng, dimension)
    local a, b = p.size / 2, p.size / 4
    if dimension == 2 then return { vertices = { { -a, -b }, { a, -b }, { a, b }, { -a, b } } } end
    local points = {}
    for _, x in ipairs { -a, a } do
      for _, y in ipairs { -a, a } do
        for _, z in ipairs { -b, b } do points[#points + 1] = { x, y, z } end
      end
    end
    return { points = points }
  end,
}
