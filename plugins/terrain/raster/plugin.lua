local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "raster",
  doc = "Heights on a square grid from a file, in 3D, of one part without a name. The ground passes through the centres of the "
    .. "cells; four neighbouring centres make two triangles, cut from south-west to north-east. It ends at the outermost "
    .. "centres, and where one of the four has no data.",
  params = {
    file = fr.file {
      doc = "an ESRI, GRASS or Surfer ASCII grid (.asc, .txt, .grd), or another format that GDAL reads, such as GeoTIFF",
    },
    scale = fr.number { default = 1, above = 0, doc = "on the heights of the file, before their unit" },
    unit = fr.choice {
      choices = { "m", "ft", "us_ft" },
      optional = true,
      doc = "of the heights; the unit of the file where it is left out, else m",
    },
    plan_unit = fr.choice {
      choices = { "m", "ft", "us_ft" },
      optional = true,
      doc = "of the coordinates and cells; m where it is left out. Places of the scenario are in m",
    },
    no_data = fr.number { optional = true, doc = "a value that means no data, in addition to that of the file" },
    fill = fr.integer {
      default = 0,
      min = 0,
      max = 100,
      doc = "cells without data inside of the grid are filled where they lie in a square of so many cells",
    },
  },
  native = "raster",
}
