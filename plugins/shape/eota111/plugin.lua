local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "eota111",
  doc = "The norm block of rock-fall tests (3D), as long as wide as high: a cube with its edges and corners cut.",
  source = "EAD 340059-00-0106, rockfall protection kits, EOTA 2018",
  params = {
    length = fr.number { above = 0, unit = "m", usual = { 0.001, 20 }, doc = "its longest side; 1.122 m make 1 m3" },
  },
  native = "eota111",
}
