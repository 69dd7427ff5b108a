// Writes the content of results.db in the formats of other programs.

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/result_folder.h"
#include "cli/terminal.h"
#include "document/wording.h"
#include "report/exports/export_asc.h"
#include "report/exports/export_csv.h"
#include "report/exports/export_dxf.h"
#include "report/exports/export_gdal.h"
#include "report/exports/export_geojson.h"
#include "report/exports/export_gltf.h"
#include "report/exports/export_hdf5.h"
#include "report/exports/export_obj.h"
#include "report/exports/export_vtk.h"
#include "solver/hdf5_file.h"
#include "survey/gdal_module.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

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
  /// The format that writes the same without GDAL, which this one needs; null: it does not.
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
    {"gpkg", export_gpkg, no_plan, "geojson", "the same layers"},
    {"hdf5", export_h5, ""},
    {"obj", export_obj, "this result has no blocks between joints"},
    {"tif", export_tif, no_maps, "asc", "the same maps"},
    {"vtk", export_vtk, no_paths},
}};

const Format& format_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Format& format : formats) {
    names.emplace_back(format.name);
    if (name != format.name) continue;
    if (format.instead && !has_gdal())
      throw UsageError(
          fmt::format("--to {} needs GDAL, which this flyrock does not have (Debian: flyrock-gdal); --to {} "
                      "writes {} without it",
                      name, format.instead, format.same));
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
