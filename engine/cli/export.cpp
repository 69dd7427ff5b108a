// Writes the content of results.db in the formats of other programs.

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/result_folder.h"
#include "document/wording.h"
#include "report/export_asc.h"
#include "report/export_csv.h"
#include "report/export_vtk.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct Format {
  const char* name;
  /// Writes the database into a folder and returns the files.
  std::vector<fs::path> (*write)(const fs::path& results, const fs::path& folder);
  const char* nothing;  ///< message if no file is written
};

constexpr std::array<Format, 3> formats = {{
    {"asc", export_asc, "no maps are stored; they are of 3D runs, see output.maps of the scenario"},
    {"csv", export_csv, ""},
    {"vtk", export_vtk, "no trajectory is stored; output.trajectories of the scenario says how many are"},
}};

const Format& format_of(const std::string& name) {
  if (name == "tif")
    throw UsageError(
        "--to tif: this flyrock cannot write GeoTIFF. Use --to asc and, of the package gdal-bin, "
        "gdal_translate MAP.asc MAP.tif");
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
  options.add_options()("to", po::value<std::string>()->value_name("FORMAT"),
                        "csv (every table), vtk (trajectories, for ParaView), asc or tif (maps, for a GIS; "
                        "tif needs GDAL); required")("output,o", po::value<std::string>()->value_name("PATH"),
                                                     "folder of the files; default DIR/<format>");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  if (!line.has("to")) throw UsageError(fmt::format("expected --to FORMAT: flyrock {}", command.usage));
  const Format& format = format_of(line.text("to"));
  const fs::path result = finished_result(line.words[0]);
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : result / format.name;
  if (fs::exists(folder / "manifest.json"))
    throw UsageError(fmt::format(
        "-o {}: it holds results, whose files would be replaced; expected another folder", folder.string()));
  const std::vector<fs::path> files = format.write(result / "results.db", folder);
  for (const fs::path& file : files) fmt::print("{}\n", file.string());
  if (files.empty()) fmt::print(stderr, "nothing written: {}\n", format.nothing);
  return done;
}

}  // namespace flyrock::cli
