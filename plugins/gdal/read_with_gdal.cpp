// flyrock_gdal.so: grids of heights in the formats that GDAL reads. A module of its own, so that flyrock runs
// without GDAL.

#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <limits>
#include <memory>

#include "plugins/terrain/raster/raster_file.h"

namespace flyrock::plugins {

namespace {

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};

std::string last_error() {
  const std::string text = CPLGetLastErrorMsg();
  return text.empty() ? "GDAL cannot read it" : text;
}

/// Fills the size and the place of the grid from the six numbers of GDAL: x = t0 + t1 column + t2 row, y = t3
/// + t4 column + t5 row, at the corners of cells. `is_north_first`: the first row is the northern one.
std::string place(const double* t, HeightGrid& grid, bool& is_north_first) {
  if (t[2] != 0 || t[4] != 0)
    return "its rows do not run from west to east, expected a grid that is not turned";
  if (!(t[1] > 0) || !(std::abs(std::abs(t[5]) - t[1]) <= 1e-6 * t[1]))
    return fmt::format("its cells are {:.10g} m by {:.10g} m, expected squares", t[1], std::abs(t[5]));
  is_north_first = t[5] < 0;
  grid.cell = t[1];
  grid.corner.x() = t[0] + t[1] / 2;
  grid.corner.y() = is_north_first ? t[3] + t[5] * (grid.rows - 0.5) : t[3] + t[5] / 2;
  return {};
}

std::string read(const std::string& path, HeightGrid& grid) {
  GDALAllRegister();
  const std::unique_ptr<void, Close> dataset(GDALOpen(path.c_str(), GA_ReadOnly));
  if (!dataset) return last_error();
  if (GDALGetRasterCount(dataset.get()) < 1) return "has no band of heights";
  const OGRSpatialReferenceH system = GDALGetSpatialRef(dataset.get());
  if (system && OSRIsGeographic(system))
    return "is in degrees, expected metres: project it first, for example with gdalwarp";
  grid.columns = GDALGetRasterXSize(dataset.get());
  grid.rows = GDALGetRasterYSize(dataset.get());
  if (static_cast<double>(grid.columns) * grid.rows > 5e8)
    return fmt::format("has {} x {} cells, expected at most 5e8", grid.columns, grid.rows);
  double transform[6];
  if (GDALGetGeoTransform(dataset.get(), transform) != CE_None)
    return "does not say where it lies (it has no geotransform)";
  bool is_north_first = true;
  if (std::string wrong = place(transform, grid, is_north_first); !wrong.empty()) return wrong;
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  grid.heights.resize(static_cast<std::size_t>(grid.columns) * grid.rows);
  for (int row = 0; row < grid.rows; ++row) {
    const int from_south = is_north_first ? grid.rows - 1 - row : row;
    double* heights = grid.heights.data() + static_cast<std::size_t>(from_south) * grid.columns;
    if (GDALRasterIO(band, GF_Read, 0, row, grid.columns, 1, heights, grid.columns, 1, GDT_Float64, 0, 0) !=
        CE_None)
      return last_error();
  }
  int has_no_data = 0;
  const double no_data = GDALGetRasterNoDataValue(band, &has_no_data);
  for (double& height : grid.heights)
    if (has_no_data && height == no_data) height = std::numeric_limits<double>::quiet_NaN();
  return {};
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void flyrock_read_with_gdal(const std::string& path,
                                                                              HeightGrid& grid,
                                                                              std::string& wrong) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  try {
    wrong = read(path, grid);
  } catch (const std::exception& error) {
    wrong = error.what();
  }
  CPLPopErrorHandler();
}

}  // namespace flyrock::plugins
