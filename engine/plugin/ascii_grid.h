#pragma once
// Grids in text files, for terrains and zones.

#include <string>

#include "geometry/height_grid.h"

namespace flyrock {

/// Reads an ESRI ASCII grid: `ncols`, `nrows`, `xllcorner` and `yllcorner` (of the cell in the south-west) or
/// `xllcenter` and `yllcenter`, `cellsize`, and `NODATA_value` where it is not -9999; then the values, the
/// first row in the north. `who` begins each error: "plugin raster". Throws PluginError, with line and
/// column.
HeightGrid read_ascii_grid(const std::string& who, const std::string& path);

}  // namespace flyrock
