local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  dimension = 2,
  name = "stone",
  doc = "A polygon with corners drawn on an ellipse.",
  params = {
    length = fr.number { default = 0.4, above = 0, unit = "m", doc = "of its longer axis" },
    corners = fr.integer { default = 7, min = 3, max = 20, doc = "of the polygon" },
  },
  build = function(p, rng)
    local vertices = {}
    for i = 1, p.corners do
      local angle = 2 * math.pi * (i + rng:uniform(-0.2, 0.2)) / p.corners
      vertices[i] = { p.length * math.cos(angle) / 2, p.length * math.sin(angle) / 3 }
    end
    return { vertices = vertices }
  end,
}
