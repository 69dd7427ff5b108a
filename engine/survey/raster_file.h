#pragma once
// Grids in files: of heights, of zones, of releases.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "geometry/height_grid.h"

namespace flyrock {

/// A grid as its file holds it. Cells without data are NaN; a scale and an offset of the file are applied.
struct RasterFile {
  HeightGrid grid;                           ///< heights and places in the units of the file
  double value_scale = 1, value_offset = 0;  ///< height = scale x value of the file + offset, done
  std::string height_unit;                   ///< metres_in() knows it; empty: the file does not say
  std::string unknown_height_unit = {};      ///< as the file writes it, where it is none that is known
  std::string plan_unit;                     ///< of places and cells; empty: the file does not say
  std::string crs;                           ///< "EPSG:2056"; empty: the file does not say
  std::vector<std::string> notes;
};

/// Reads a grid: names that end in .asc, .txt or .grd by read_ascii_grid, others through the module
/// flyrock_gdal.so beside flyrock_plugins.so. `no_data`: a value that means no data, in addition to those
/// that the file names. `who` begins each error: "plugin raster". Throws PluginError.
RasterFile read_raster_file(const std::string& who, const std::string& path, std::optional<double> no_data);

/// Reads a text grid. ESRI ASCII: `ncols`, `nrows`, `xllcorner` and `yllcorner` (of the cell in the
/// south-west) or `xllcenter` and `yllcenter`, `cellsize` or `dx` and `dy`, and `NODATA_value` where it is
/// not -9999, in any order; then the values, the first row in the north. GRASS ASCII: `north`, `south`,
/// `east`, `west`, `rows`, `cols`. Surfer ASCII: `DSAA`, sizes and ranges; then the values, the first row in
/// the south. A file of the same name with the ending .prj gives the coordinate system. Throws PluginError,
/// with line and column.
RasterFile read_ascii_grid(const std::string& who, const std::string& path, std::optional<double> no_data);

/// Whether a value of a file is the one that means no data: a file may write the same number in single
/// precision, or with six digits where it is no height.
inline bool is_no_data(double value, double no_data) {
  const double digits = std::abs(no_data) > 9000 ? 5e-6 : 1e-7;
  return std::isnan(value) || std::abs(value - no_data) <= digits * std::abs(no_data);
}

/// Metres in a unit of length, also `us_ft`; 0 for another text.
double metres_in(const std::string& unit);

/// The side of cells that are squares to 1e-4; nothing if they are not.
inline std::optional<double> square_cell(double dx, double dy) {
  constexpr double tolerance = 1e-4;  // after 1000 cells a tenth of one
  if (!(std::abs(dx - dy) <= tolerance * dx)) return std::nullopt;
  return std::abs(dx - dy) <= 1e-9 * dx ? dx : 0.5 * (dx + dy);
}

/// The entry of flyrock_gdal.so: fills `file`, or says in `wrong` what is wrong with it.
using GdalReader = void (*)(const std::string& path, std::optional<double> no_data, RasterFile& file,
                            std::string& wrong);
inline constexpr const char* gdal_entry = "flyrock_read_with_gdal";

}  // namespace flyrock
