#pragma once
// Exports maps as ESRI ASCII grids.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point with maps in the database `results`, a file
/// <raster>-p<point>.asc for each of map_names that the point has: six header lines (ncols, nrows, xllcorner,
/// yllcorner, cellsize, NODATA_value), then the rows from the north, -9999 where no rock passed. Where the
/// coordinate system is known, <raster>-p<point>.vrt beside it shows the grid with it. Returns the grids.
/// Throws FileError.
std::vector<std::filesystem::path> export_asc(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
