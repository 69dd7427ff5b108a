#include "report/exports/export_gdal.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "files/safe_file.h"
#include "report/exports/export_asc.h"
#include "report/exports/export_geojson.h"
#include "report/tables/stored_scene.h"
#include "survey/gdal_module.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

/// The options are those of the programs gdal_translate and ogr2ogr.
void translate(const char* entry, const std::vector<std::string>& options, const fs::path& from,
               const fs::path& to) {
  const auto write =
      reinterpret_cast<GdalTranslator>(gdal_entry_point(to.string(), entry, "export in another format"));
  if (!write(options, from.string(), to.string()))
    throw FileError(fmt::format("{}: GDAL cannot write it", to.string()));
}

/// "paths-p0" as its layer, and the sweep point, "p0".
std::pair<std::string, std::string> layer_and_point(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t cut = stem.rfind('-');
  return {stem.substr(0, cut), stem.substr(cut + 1)};
}

}  // namespace

std::vector<fs::path> export_tif(const fs::path& results, const fs::path& folder) {
  const std::string crs = stored_crs(SqliteReader(results));
  std::vector<std::string> options = {"-of", "GTiff"};
  if (!crs.empty()) options.insert(options.end(), {"-a_srs", crs});
  std::vector<fs::path> files = export_asc(results, folder);
  for (fs::path& file : files) {
    const fs::path grid = file;
    file.replace_extension(".tif");
    translate(raster_translator, options, grid, file);
    fs::remove(grid);
    fs::remove(fs::path(grid).replace_extension(".vrt"));
  }
  return files;
}

std::vector<fs::path> export_gpkg(const fs::path& results, const fs::path& folder) {
  const std::string crs = stored_crs(SqliteReader(results));
  std::vector<fs::path> packages;
  for (const fs::path& layer : export_geojson(results, folder)) {
    const auto [name, point] = layer_and_point(layer);
    const fs::path package = folder / fmt::format("results-{}.gpkg", point);
    const bool is_new = packages.empty() || packages.back() != package;
    if (is_new) {
      fs::remove(package);
      packages.push_back(package);
    }
    std::vector<std::string> options = {"-f", "GPKG", "-nln", name, "-a_srs", crs.empty() ? "NONE" : crs};
    if (!is_new) options.insert(options.end(), {"-update", "-append"});
    translate(layer_translator, options, layer, package);
    fs::remove(layer);
  }
  return packages;
}

}  // namespace flyrock
