#include "survey/raster_file.h"

#include <fmt/format.h>

#include "plugin/params.h"
#include "survey/file_form.h"
#include "survey/gdal_module.h"
#include "units/units.h"

namespace flyrock {

namespace {

RasterFile read_with_gdal(const std::string& who, const std::string& path, std::optional<double> no_data) {
  const std::string where = fmt::format("{}: {}", who, path);
  const std::string other = other_form(path, "raster");
  if (!other.empty() && !has_gdal()) throw PluginError(fmt::format("{}: {}", where, other));
  const auto read = reinterpret_cast<GdalReader>(
      gdal_entry_point(where, gdal_entry, "convert the file to an ESRI ASCII grid (.asc)"));
  RasterFile file;
  std::string wrong;
  read(path, no_data, file, wrong);
  if (!wrong.empty()) throw PluginError(fmt::format("{}: {}", where, other.empty() ? wrong : other));
  return file;
}

}  // namespace

RasterFile read_raster_file(const std::string& who, const std::string& path, std::optional<double> no_data) {
  const std::string ending = ending_of(path);
  const bool is_text = ending == ".asc" || ending == ".txt" || ending == ".grd";
  return is_text ? read_ascii_grid(who, path, no_data) : read_with_gdal(who, path, no_data);
}

double metres_in(const std::string& unit) {
  if (unit == "us_ft") return 1200.0 / 3937.0;
  const auto known = parse_unit(unit);
  return known && known->dimension == dimension::length ? known->factor : 0;
}

}  // namespace flyrock
