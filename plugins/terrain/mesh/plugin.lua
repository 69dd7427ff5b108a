local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "mesh",
  doc = "A surface of triangles from a file, in 3D. Overhangs and upright faces are allowed. The groups and objects of an "
    .. "OBJ file are parts, and so are the layers of a drawing (DXF).",
  params = {
    file = fr.file { doc = "an OBJ, PLY or STL file in metres, LandXML, or with GDAL a DXF file of 3D faces; corners counter-clockwise, seen from outside of the ground (in LandXML and DXF in any order)" },
    surface = fr.text { optional = true, doc = "of a LandXML file: which of its surfaces is the ground; of a DXF file: the layer of the drawing, in place of all" },
    up = fr.choice { choices = { "z", "y" }, default = "z", doc = "which axis of the file points up" },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file" },
    parts = fr.choice {
      choices = { "groups", "materials" },
      optional = true,
      doc = "of an OBJ file: its groups and objects, or the names after `usemtl`; these where no face has a group",
    },
    repair = fr.group {
      doc = "what may be changed in a mesh that is no ground",
      params = {
        weld = fr.number { default = 0, min = 0, max = 10, unit = "m", doc = "joins borders that are no farther apart" },
        fill_holes = fr.integer { default = 0, min = 0, max = 200, doc = "fills holes of at most so many edges" },
        keep = fr.choice { choices = { "all", "largest" }, default = "all", doc = "which pieces stay" },
      },
    },
  },
  native = "mesh",
}
