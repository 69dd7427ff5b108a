// Writes the content of results.db in the formats of other programs.

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <utility>

#include "cli/result_folder.h"
#include "cli/run_program.h"
#include "cli/terminal.h"
#include "document/wording.h"
#include "report/exports/export_asc.h"
#include "report/exports/export_csv.h"
#include "report/exports/export_dxf.h"
#include "report/exports/export_geojson.h"
#include "report/exports/export_gltf.h"
#include "report/exports/export_hdf5.h"
#include "report/exports/export_obj.h"
#include "report/exports/export_vtk.h"
#include "report/tables/stored_scene.h"
#include "solver/hdf5_file.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// Maps as GeoTIFF with numbers of 64 bits: the ASCII grids, as the program gdal_translate reads them.
std::vector<fs::path> export_tif(const fs::path& results, const fs::path& folder) {
  const std::string crs = stored_crs(SqliteReader(results));
  std::vector<fs::path> files = export_asc(results, folder);
  for (fs::path& file : files) {
    const fs::path grid = file;
    file.replace_extension(".tif");
    std::vector<std::string> words = {"gdal_translate", "-q", "-of", "GTiff", "-oo", "DATATYPE=Float64"};
    if (!crs.empty()) words.insert(words.end(), {"-a_srs", crs});
    words.insert(words.end(), {grid.string(), file.string()});
    const bool made = run_program(words);
    fs::remove(grid);
    fs::remove(fs::path(grid).replace_extension(".vrt"));
    if (!made) throw InputError(fmt::format("{}: GDAL's gdal_translate cannot write it", file.string()));
  }
  return files;
}

/// "paths-p0" as its layer, and the sweep point, "p0".
std::pair<std::string, std::string> layer_and_point(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t cut = stem.rfind('-');
  return {stem.substr(0, cut), stem.substr(cut + 1)};
}

/// A GeoPackage for each sweep point: the GeoJSON files as its layers, as the program ogr2ogr reads them.
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
    std::vector<std::string> words = {"ogr2ogr", "-f", "GPKG", "-nln", name};
    words.insert(words.end(), {"-a_srs", crs.empty() ? "NONE" : crs});
    // The time of the change would differ in each export.
    words.insert(words.end(), {"--config", "OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"});
    if (!is_new) words.insert(words.end(), {"-update", "-append"});
    words.insert(words.end(), {package.string(), layer.string()});
    const bool made = run_program(words);
    fs::remove(layer);
    if (!made) throw InputError(fmt::format("{}: GDAL's ogr2ogr cannot write it", package.string()));
  }
  return packages;
}

std::vector<fs::path> export_h5(const fs::path& results, const fs::path& folder) {
  if (!has_hdf5())
    throw UsageError(
        "--to hdf5: this flyrock was built without HDF5 (Debian: libhdf5-dev); --to csv writes the same "
        "tables without it");
  return export_hdf5(results, folder);
}

struct Format {
  const char* name;
  /// Writes the database into a folder and returns the files.
  std::vector<fs::path> (*write)(const fs::path& results, const fs::path& folder);
  const char* nothing;  ///< message if no file is written
  /// The program of GDAL that it needs, and the format that writes the same without; null: none.
  const char* program = nullptr;
  const char* instead = nullptr;
  const char* same = nullptr;
};

constexpr const char* no_maps =
    "this result has no maps (only runs in 3D make maps; see output.maps of the scenario)";

constexpr const char* no_paths =
    "no trajectory is stored; output.trajectories of the scenario says how many are";

constexpr const char* no_plan = "this result has no places in plan (only runs in 3D do)";

constexpr std::array<Format, 10> formats = {{
    {"asc", export_asc, no_maps},
    {"csv", export_csv, ""},
    {"dxf", export_dxf, "this result has no places"},
    {"geojson", export_geojson, no_plan},
    {"gltf", export_gltf, no_paths},
    {"gpkg", export_gpkg, no_plan, "ogr2ogr", "geojson", "the same layers"},
    {"hdf5", export_h5, ""},
    {"obj", export_obj, "this result has no blocks between joints"},
    {"tif", export_tif, no_maps, "gdal_translate", "asc", "the same maps"},
    {"vtk", export_vtk, no_paths},
}};

const Format& format_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Format& format : formats) {
    names.emplace_back(format.name);
    if (name != format.name) continue;
    if (format.program && !has_program(format.program))
      throw UsageError(
          fmt::format("--to {} needs the program {} (Debian: gdal-bin); --to {} writes {} without it", name,
                      format.program, format.instead, format.same));
    return format;
  }
  throw UsageError(fmt::format("--to: unknown format `{}`{}", name, suggestion(name, names)));
}

}  // namespace

int export_result(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()(
      "to", po::value<std::string>()->value_name("csv|hdf5|vtk|gltf|obj|dxf|geojson|gpkg|asc|tif"),
      "csv or hdf5 (every table), vtk (trajectories, for ParaView), gltf (moving rocks, for viewers of 3D "
      "models), obj (blocks between joints), dxf (paths, ends, area; in 2D a section with envelopes); for a "
      "GIS: geojson or gpkg (paths, "
      "ends, gates, barriers, trees, zones, area), asc or tif (maps); gpkg and tif need GDAL; "
      "required")("output,o", po::value<std::string>()->value_name("FILE|DIR"),
                  "folder of the files; default DIR/<format>")(
      "force", "writes into a folder that holds results, too");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  if (!line.has("to")) throw UsageError(fmt::format("expected --to FORMAT: flyrock {}", command.usage));
  const Format& format = format_of(line.text("to"));
  const fs::path result = finished_result(line.words[0]);
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : result / format.name;
  std::error_code no_path;  // a name that is too long is reported when the folder is made
  if (fs::exists(folder / "manifest.json", no_path) && !line.has("force"))
    throw UsageError(fmt::format(
        "-o {}: it holds results, whose files would be replaced; expected another folder, or --force",
        folder.string()));
  const std::vector<fs::path> files = format.write(result / "results.db", folder);
  for (const fs::path& file : files) fmt::print("{}\n", file.string());
  if (files.empty()) tell("nothing written: {}\n", format.nothing);
  return done;
}

}  // namespace flyrock::cli
