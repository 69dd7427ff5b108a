local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "raster",
  doc = "Heights on a square grid from a file, in 3D, of one part without a name. The ground passes through the centres of the "
    .. "cells; four neighbouring centres make two triangles, cut from south-west to north-east. It ends at the outermost "
    .. "centres, and where one of the four has no data.",
  params = {
    file = fr.file {
      doc = "an ESRI ASCII grid in metres (.asc, .txt, .grd), or another format that GDAL reads, such as GeoTIFF",
    },
  },
  native = "raster",
}
