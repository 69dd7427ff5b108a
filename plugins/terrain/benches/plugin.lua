local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "benches",
  doc = "Quarry benches: x = 0 at the uppermost crest, y = 0 on the floor, rocks fall towards +x; bench 1 is the "
    .. "uppermost. Behind its crest lie 50 m of berm. Parts: face, berm, floor.",
  params = {
    count = fr.integer { min = 1, max = 1000, doc = "number of benches" },
    height = fr.number { above = 0, unit = "m", usual = { 1, 60 }, doc = "height of a bench" },
    face_angle = fr.number { above = 0, max = 90, unit = "deg", usual = { 20, 90 }, doc = "dip of the faces" },
    berm = fr.number { min = 0, unit = "m", doc = "width of the berms between two benches; 0 joins their faces" },
    floor = fr.number { above = 0, unit = "m", doc = "length of the floor beyond the lowest toe" },
  },
  native = "benches",
}
