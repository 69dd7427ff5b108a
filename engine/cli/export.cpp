// Writes the content of results.db in the formats of other programs.

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/result_folder.h"
#include "cli/run_program.h"
#include "cli/terminal.h"
#include "document/wording.h"
#include "report/export_asc.h"
#include "report/export_csv.h"
#include "report/export_vtk.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// Maps as GeoTIFF with numbers of 64 bits: the ASCII grids, as the program gdal_translate reads them.
std::vector<fs::path> export_tif(const fs::path& results, const fs::path& folder) {
  std::vector<fs::path> files = export_asc(results, folder);
  for (fs::path& file : files) {
    const fs::path grid = file;
    file.replace_extension(".tif");
    const bool made = run_program(
        {"gdal_translate", "-q", "-of", "GTiff", "-oo", "DATATYPE=Float64", grid.string(), file.string()});
    fs::remove(grid);
    if (!made) throw InputError(fmt::format("{}: GDAL's gdal_translate cannot write it", file.string()));
  }
  return files;
}

struct Format {
  const char* name;
  /// Writes the database into a folder and returns the files.
  std::vector<fs::path> (*write)(const fs::path& results, const fs::path& folder);
  const char* nothing;  ///< message if no file is written
};

constexpr const char* no_maps =
    "this result has no maps (only runs in 3D make maps; see output.maps of the scenario)";

constexpr std::array<Format, 4> formats = {{
    {"asc", export_asc, no_maps},
    {"csv", export_csv, ""},
    {"tif", export_tif, no_maps},
    {"vtk", export_vtk, "no trajectory is stored; output.trajectories of the scenario says how many are"},
}};

const Format& format_of(const std::string& name) {
  if (name == "tif" && !has_program("gdal_translate"))
    throw UsageError(
        "--to tif needs the program gdal_translate (Debian: gdal-bin); --to asc writes the same maps without "
        "it");
  std::vector<std::string> names;
  for (const Format& format : formats) {
    if (name == format.name) return format;
    names.emplace_back(format.name);
  }
  throw UsageError(fmt::format("--to: unknown format `{}`{}", name, suggestion(name, names)));
}

}  // namespace

int export_result(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("to", po::value<std::string>()->value_name("csv|vtk|asc|tif"),
                        "csv (every table), vtk (trajectories, for ParaView), asc or tif (maps, for a GIS; "
                        "tif needs GDAL); required")("output,o",
                                                     po::value<std::string>()->value_name("FILE|DIR"),
                                                     "folder of the files; default DIR/<format>");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  if (!line.has("to")) throw UsageError(fmt::format("expected --to FORMAT: flyrock {}", command.usage));
  const Format& format = format_of(line.text("to"));
  const fs::path result = finished_result(line.words[0]);
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : result / format.name;
  std::error_code no_path;  // a name that is too long is reported when the folder is made
  if (fs::exists(folder / "manifest.json", no_path))
    throw UsageError(fmt::format(
        "-o {}: it holds results, whose files would be replaced; expected another folder", folder.string()));
  const std::vector<fs::path> files = format.write(result / "results.db", folder);
  for (const fs::path& file : files) fmt::print("{}\n", file.string());
  if (files.empty()) tell("nothing written: {}\n", format.nothing);
  return done;
}

}  // namespace flyrock::cli
