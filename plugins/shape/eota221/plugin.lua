local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "eota221",
  doc = "The flat norm block of rock-fall tests (3D), half as high as long and wide.",
  source = "EAD 340059-00-0106, rockfall protection kits, EOTA 2018",
  params = {
    length = fr.number { above = 0, unit = "m", usual = { 0.001, 20 }, doc = "its longest side; 1.413 m make 1 m3" },
  },
  native = "eota221",
}
