// flyrock_gdal.so: grids in the formats that GDAL reads. A module of its own, so that flyrock runs without
// GDAL.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "survey/raster_file.h"

namespace flyrock {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};

/// Why the file cannot be opened: GDAL's text names the file, and what is missing.
std::string last_error() {
  const std::string text = CPLGetLastErrorMsg();
  return text.empty() ? "GDAL cannot read it" : text;
}

std::string cut_at(int row) {
  return fmt::format("the file is cut or damaged: its rows from {} on cannot be read", row);
}

/// Fills the size and the place of the grid from the six numbers of GDAL: x = t0 + t1 column + t2 row, y = t3
/// + t4 column + t5 row, at the corners of cells. `is_north_first`: the first row is the northern one.
std::string place(const double* t, HeightGrid& grid, bool& is_north_first) {
  constexpr double least_turn =
      1e-6;  // what programs leave of a rotation of 0: a hundredth of a cell in 10,000
  if (!(std::abs(t[2]) <= least_turn * std::abs(t[1])) || !(std::abs(t[4]) <= least_turn * std::abs(t[1])))
    return "its rows do not run from west to east, expected a grid that is not turned: `gdalwarp` turns it";
  const double dx = t[1], dy = std::abs(t[5]);
  const auto cell = dx > 0 ? square_cell(dx, dy) : std::nullopt;
  if (!cell)
    return fmt::format(
        "its cells are {:.10g} m by {:.10g} m, expected squares: `gdalwarp -tr {:.6g} {:.6g}` resamples it",
        dx, dy, dx, dx);
  is_north_first = t[5] < 0;
  grid.cell = *cell;
  grid.corner.x() = t[0] + t[1] / 2;
  grid.corner.y() = is_north_first ? t[3] + t[5] * (grid.rows - 0.5) : t[3] + t[5] / 2;
  return {};
}

std::string unit_of_metres(double metres) {
  if (std::abs(metres - 1) < 1e-9) return "m";
  if (std::abs(metres - 0.3048) < 1e-9) return "ft";
  if (std::abs(metres - 1200.0 / 3937.0) < 1e-9) return "us_ft";
  return {};
}

/// The unit (metres_in) of the names that files have; empty for another one.
std::string unit_of_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t above = name.find(" a");  // "m a.s.l.", "metres above sea level"
  if (above != name.npos) name.resize(above);
  for (const char* metre : {"m", "metre", "meter", "metres", "meters"})
    if (name == metre) return "m";
  for (const auto& [unit, word] : {std::pair("dm", "decimet"), std::pair("cm", "centimet"),
                                   std::pair("mm", "millimet"), std::pair("km", "kilomet")})
    if (name == unit || name.starts_with(word)) return unit;
  const bool is_foot =
      name.find("foot") != name.npos || name.find("feet") != name.npos || name.find("ft") != name.npos;
  if (!is_foot) return {};
  return name.find("us") != name.npos || name.find("u.s") != name.npos || name.find("survey") != name.npos
             ? "us_ft"
             : "ft";
}

/// The units of the coordinate system. `far`: the greatest coordinate of the grid.
std::string read_system(OGRSpatialReferenceH system, double far, RasterFile& file) {
  if (!system) return {};
  const char* authority = OSRGetAuthorityName(system, nullptr);
  const char* code = OSRGetAuthorityCode(system, nullptr);
  if (authority && code && std::string(authority) == "EPSG") file.crs = fmt::format("EPSG:{}", code);
  if (OSRIsGeographic(system)) {
    if (far <= 360) return "is in degrees, expected metres: project it first, for example with gdalwarp";
    file.crs.clear();
    file.notes.push_back(
        "its coordinate system is in degrees, its coordinates are not: they are taken as metres");
    return {};
  }
  if (!OSRIsProjected(system)) return {};
  char* name = nullptr;
  const double metres = OSRGetLinearUnits(system, &name);
  file.plan_unit = unit_of_metres(metres);
  if (file.plan_unit.empty())
    return fmt::format(
        "its coordinates are in units of {:.10g} m ({}), expected metres or feet: project it first, for "
        "example with gdalwarp",
        metres, name ? name : "");
  return {};
}

/// Why the first band holds no heights; empty if it may.
std::string picture_fault(GDALRasterBandH band) {
  const GDALColorInterp colour = GDALGetRasterColorInterpretation(band);
  if (colour == GCI_RedBand || colour == GCI_GreenBand || colour == GCI_BlueBand)
    return "its first band is a colour of a picture, expected heights";
  if (colour == GCI_PaletteIndex || GDALGetRasterColorTable(band))
    return "its first band holds numbers of a palette of colours, expected heights";
  return {};
}

/// Values, with NaN where the band, its mask or the user says that there is no data, scaled as the band says.
std::string read_values(GDALRasterBandH band, std::optional<double> no_data, bool is_north_first,
                        RasterFile& file) {
  HeightGrid& grid = file.grid;
  int has_no_data = 0, has_scale = 0, has_offset = 0;
  const double own_no_data = GDALGetRasterNoDataValue(band, &has_no_data);
  const double scale = GDALGetRasterScale(band, &has_scale), offset = GDALGetRasterOffset(band, &has_offset);
  if (has_scale) file.value_scale = scale;
  if (has_offset) file.value_offset = offset;
  const int flags = GDALGetMaskFlags(band);
  const bool has_mask = (flags & (GMF_ALL_VALID | GMF_NODATA)) == 0;
  const GDALRasterBandH mask = has_mask ? GDALGetMaskBand(band) : nullptr;
  std::vector<std::uint8_t> valid(static_cast<std::size_t>(grid.columns), 255);
  grid.heights.resize(static_cast<std::size_t>(grid.columns) * grid.rows);
  for (int row = 0; row < grid.rows; ++row) {
    const int from_south = is_north_first ? grid.rows - 1 - row : row;
    double* heights = grid.heights.data() + static_cast<std::size_t>(from_south) * grid.columns;
    if (GDALRasterIO(band, GF_Read, 0, row, grid.columns, 1, heights, grid.columns, 1, GDT_Float64, 0, 0) !=
        CE_None)
      return cut_at(row);
    if (mask && GDALRasterIO(mask, GF_Read, 0, row, grid.columns, 1, valid.data(), grid.columns, 1, GDT_Byte,
                             0, 0) != CE_None)
      return cut_at(row);
    for (int column = 0; column < grid.columns; ++column) {
      double& z = heights[column];
      const bool is_void = valid[static_cast<std::size_t>(column)] == 0 || !std::isfinite(z) ||
                           (has_no_data && is_no_data(z, own_no_data)) ||
                           (no_data && is_no_data(z, *no_data));
      if (is_void)
        z = nothing;
      else
        z = z * file.value_scale + file.value_offset;
    }
  }
  return {};
}

std::string read(const std::string& path, std::optional<double> no_data, RasterFile& file) {
  GDALAllRegister();
  const std::unique_ptr<void, Close> dataset(GDALOpen(path.c_str(), GA_ReadOnly));
  if (!dataset) return last_error();
  const int bands = GDALGetRasterCount(dataset.get());
  if (bands < 1) return "has no band of heights";
  HeightGrid& grid = file.grid;
  grid.columns = GDALGetRasterXSize(dataset.get());
  grid.rows = GDALGetRasterYSize(dataset.get());
  if (static_cast<double>(grid.columns) * grid.rows > 5e8)
    return fmt::format("has {} x {} cells, expected at most 5e8", grid.columns, grid.rows);
  double transform[6];
  if (GDALGetGeoTransform(dataset.get(), transform) != CE_None)
    return "does not say where it lies (it has no geotransform)";
  const double far = std::max({std::abs(transform[0]), std::abs(transform[3]),
                               std::abs(transform[0] + transform[1] * grid.columns),
                               std::abs(transform[3] + transform[5] * grid.rows)});
  if (std::string wrong = read_system(GDALGetSpatialRef(dataset.get()), far, file); !wrong.empty())
    return wrong;
  bool is_north_first = true;
  if (std::string wrong = place(transform, grid, is_north_first); !wrong.empty()) return wrong;
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  if (std::string wrong = picture_fault(band); !wrong.empty()) return wrong;
  if (bands > 1) file.notes.push_back(fmt::format("has {} bands, of which the first is read", bands));
  const std::string unit = GDALGetRasterUnitType(band);
  file.height_unit = unit_of_name(unit);
  file.unknown_height_unit = file.height_unit.empty() ? unit : "";
  return read_values(band, no_data, is_north_first, file);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void flyrock_read_with_gdal(const std::string& path,
                                                                              std::optional<double> no_data,
                                                                              RasterFile& file,
                                                                              std::string& wrong) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  try {
    wrong = read(path, no_data, file);
  } catch (const std::exception& error) {
    wrong = error.what();
  }
  CPLPopErrorHandler();
}

}  // namespace flyrock
