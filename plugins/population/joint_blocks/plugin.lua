local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "joint_blocks",
  doc = "The blocks into which joints cut a region of rock. Plane k of a set lies at origin + d_k along its own normal, and "
    .. "`spacing` is the law of the differences of the d_k; with `radius` the joints of a set are discs, a Poisson process with the "
    .. "area 1/spacing a volume. Blocks stay convex: a joint runs on to the next joint, and one that ends inside a block is left "
    .. "out. Measured planes are cut first, then the sets in their order. Needs `rock_contacts: on`.",
  validity = "blocks that slide or fall without rotation are judged by the table `blocks`; toppling, what neighbours do and "
    .. "bridges of rock are not seen by it. Joints are closed at the start.",
  reads = {},
  params = {
    region = fr.records {
      single = true,
      words = { "notch" },
      fields = { points = fr.points { unit = "m", doc = "corners; in 3D their convex hull, in 2D a convex polygon" } },
      doc = "the rock that is cut: what the `notch` of a bench takes out, or `{ points: [...] }` above the ground",
    },
    sets = fr.records {
      optional = true,
      file = true,
      fields = {
        name = fr.text { optional = true, doc = "in tables; else set_1, set_2, ..." },
        dip = fr.number { optional = true, needed_in = 3, min = 0, max = 90, unit = "deg", doc = "3D: from the horizontal" },
        dip_direction = fr.number { optional = true, needed_in = 3, min = 0, max = 360, unit = "deg", doc = "3D: a bearing, clockwise from north" },
        angle = fr.number { optional = true, needed_in = 2, min = -180, max = 180, unit = "deg", doc = "2D: of the line, from +x counter-clockwise" },
        fisher_k = fr.number {
          optional = true,
          above = 0,
          max = 1e5,
          doc = "concentration of the normals about their mean (Fisher; in 2D von Mises); else all are parallel",
        },
        spacing = fr.law { above = 0, unit = "m", doc = "of the planes along their normals; of discs its mean counts" },
        persistence = fr.number { optional = true, above = 0, max = 1, doc = "probability with which a plane cuts a block it meets; else 1" },
        radius = fr.law { optional = true, above = 0, unit = "m", doc = "the joints are discs (2D: segments, half their length)" },
        origin = fr.vector { optional = true, unit = "m", doc = "a place that a plane of the set goes through; else random" },
      },
      doc = "sets of joints, or a file with them, such as that of `flyrock joints`",
    },
    planes = fr.records {
      optional = true,
      file = true,
      fields = {
        dip = fr.number { optional = true, needed_in = 3, min = 0, max = 90, unit = "deg", doc = "3D: from the horizontal" },
        dip_direction = fr.number { optional = true, needed_in = 3, min = 0, max = 360, unit = "deg", doc = "3D: a bearing, clockwise from north" },
        angle = fr.number { optional = true, needed_in = 2, min = -180, max = 180, unit = "deg", doc = "2D: of the line, from +x counter-clockwise" },
        x = fr.number { optional = true, unit = "m", doc = "a place on it; without a place it lies at random in the region" },
        y = fr.number { optional = true, unit = "m", doc = "a place on it" },
        z = fr.number { optional = true, unit = "m", doc = "a place on it, in 3D" },
        radius = fr.number { optional = true, above = 0, unit = "m", doc = "it is a disc about its place (2D: a segment)" },
        set = fr.text { optional = true, doc = "its name in tables" },
      },
      doc = "measured joints, or a table with them",
    },
    least_volume = fr.number {
      default = 1e-3,
      min = 0,
      unit = "m3",
      doc = "smaller blocks are left out, and leave a gap; in 2D an area in m2",
    },
    most_blocks = fr.integer { default = 2000, min = 1, max = 100000, doc = "more are refused" },
    only = fr.choice {
      choices = { "all", "removable", "factor_below_1" },
      default = "all",
      doc = "which blocks move; the rest is fixed, and in no table but `blocks`",
    },
    horizontal = fr.number { default = 0, min = -1, max = 1, doc = "a horizontal force on each block as a share of its weight, in its factor" },
    bearing = fr.number {
      optional = true,
      min = 0,
      max = 360,
      unit = "deg",
      doc = "3D: of the horizontal force, a bearing, clockwise from north; else out of the notch. In 2D it acts along +x",
    },
    water = fr.number {
      default = 0,
      min = 0,
      max = 1,
      doc = "how full of water the joints are: the mean pressure on each is water gamma_w H/6 with the height H from the lowest point "
        .. "of the block to the crest of the region (Hoek and Bray), in its factor",
    },
    bolts = fr.records {
      optional = true,
      fields = {
        at = fr.vector { unit = "m", doc = "a place in the block that it holds" },
        trend = fr.number { default = 0, min = -360, max = 360, unit = "deg", doc = "3D: of its pull on the block, a bearing, clockwise from north" },
        plunge = fr.number { min = -180, max = 180, unit = "deg", doc = "of its pull below the horizontal, in 2D from +x clockwise" },
        force = fr.number { above = 0, unit = "N", doc = "in 2D per metre of width" },
      },
      doc = "forces of bolts, in the factor of their blocks",
    },
  },
  native = "joint_blocks",
}
