local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "steps",
  doc = "Stairs with drawn widths.",
  params = {
    rise = fr.number { default = 3, above = 0, unit = "m", doc = "of a step" },
    count = fr.integer { default = 4, min = 1, max = 30, doc = "of steps" },
    start = fr.vector { default = { 0, 12 }, unit = "m", doc = "its upper end" },
    names = fr.text { default = "tread", doc = "of its level parts" },
  },
  build = function(p, rng)
    local x, y = p.start[1], p.start[2]
    local points, parts = { { x - 10, y }, { x, y } }, { p.names }
    for i = 1, p.count do
      x, y = x + 1, y - p.rise
      points[#points + 1] = { x, y }
      parts[#parts + 1] = "face"
      x = x + rng:uniform(4, 8)
      points[#points + 1] = { x, y }
      parts[#parts + 1] = p.names
    end
    return { points = points, parts = parts }
  end,
}
