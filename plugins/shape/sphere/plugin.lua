local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "sphere",
  doc = "A sphere (3D): the rock that rolls. On a level floor only rolling resistance stops it.",
  params = {
    radius = fr.number { above = 0, unit = "m", usual = { 0.0005, 10 }, doc = "radius" },
  },
  native = "sphere",
}
