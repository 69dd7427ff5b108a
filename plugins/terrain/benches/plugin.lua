local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "benches",
  doc = "Quarry benches: x = 0 at the uppermost crest, height 0 on the floor, rocks fall towards +x; bench 1 is the "
    .. "uppermost. Behind its crest lies a berm (`top`). In 3D y runs along the crest, from -length/2 to length/2. Parts: face, "
    .. "berm, floor, and ditch and bund where they are given.",
  params = {
    count = fr.integer { min = 1, max = 1000, doc = "number of benches" },
    height = fr.number { above = 0, unit = "m", usual = { 1, 60 }, doc = "height of a bench" },
    face_angle = fr.number { above = 0, max = 90, unit = "deg", usual = { 30, 90 }, doc = "dip of the faces" },
    berm = fr.number { min = 0, unit = "m", doc = "width of the berms between two benches; 0 joins their faces" },
    floor = fr.number { min = 0.01, unit = "m", doc = "length of the floor beyond the lowest toe" },
    top = fr.number {
      optional = true,
      above = 0,
      unit = "m",
      doc = "length of the berm behind the uppermost crest; 50 m where it is left out",
    },
    length = fr.number { optional = true, above = 0, unit = "m", doc = "3D: of the crest; 100 m where it is left out" },
    azimuth = fr.number {
      optional = true,
      unit = "deg",
      doc = "3D: where the faces look, from +x towards +y; 0 where it is left out. All turns about the z axis. Or "
        .. "`bearing`",
    },
    line = fr.plan_points {
      optional = true,
      unit = "m",
      doc = "3D: the uppermost crest in plan, in place of length and azimuth: the faces look to the right of its direction, "
        .. "lower edges are parallel with mitred corners",
    },
    ditch = fr.group {
      doc = "at the lowest toe: the lowest face goes on down to its bottom",
      params = {
        width = fr.number { above = 0, unit = "m", doc = "of its level bottom" },
        depth = fr.number { above = 0, unit = "m", doc = "below the floor" },
        slope = fr.number { default = 45, above = 0, max = 90, unit = "deg", doc = "of its far side, up to the floor" },
      },
    },
    bund = fr.group {
      doc = "a bank on the floor or on the berms",
      params = {
        height = fr.number { above = 0, unit = "m", doc = "above the ground" },
        top = fr.number { default = 1, min = 0, unit = "m", doc = "width of its level top" },
        slope = fr.number { default = 37, above = 0, max = 90, unit = "deg", doc = "of its sides" },
        on = fr.choice {
          choices = { "floor", "berm" },
          default = "floor",
          doc = "berm: at the outer edge of each berm between two benches",
        },
        distance = fr.number {
          optional = true,
          min = 0,
          unit = "m",
          doc = "on the floor: from the ditch, or from the lowest toe; 0 where it is left out",
        },
      },
    },
    notch = fr.group {
      doc = "a prism taken out of a bench, as room for `joint_blocks`: between the face, a plane parallel to it and a base through "
        .. "the toe, in 3D with upright ends. Parts: notch_back, notch_base, notch_end. With a straight crest, without ditch, "
        .. "roughness and bunds on berms",
      params = {
        bench = fr.integer { default = 1, min = 1, doc = "which one" },
        depth = fr.number { above = 0, unit = "m", doc = "horizontal, from the face into the rock; less than the berm above" },
        base = fr.number { default = 0, min = 0, below = 90, unit = "deg", doc = "by which its base rises from the toe into the rock" },
        from = fr.number { optional = true, unit = "m", doc = "3D: where it begins along the crest, from the middle" },
        to = fr.number { optional = true, unit = "m", doc = "3D: where it ends" },
      },
    },
    roughness = fr.group {
      doc = "random heights of faces and berms along their normal, drawn once per trial, with the spectrum "
        .. "(1 + (k length)^2)^-(hurst + (D-1)/2)",
      params = {
        sd = fr.number { min = 0, unit = "m", doc = "standard deviation" },
        length = fr.number { above = 0, unit = "m", doc = "beyond which heights are independent" },
        hurst = fr.number { default = 0.8, above = 0, max = 1, doc = "from jagged (0) to smooth (1)" },
        cell = fr.number {
          optional = true,
          above = 0,
          unit = "m",
          doc = "about the distance of neighbouring heights; length/4 where it is left out",
        },
      },
    },
  },
  native = "benches",
}
