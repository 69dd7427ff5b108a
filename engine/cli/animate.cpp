// flyrock animate: the motion of the stored rocks as a picture that moves.

#include <fmt/format.h>

#include <filesystem>

#include "batch/safe_file.h"
#include "cli/result_folder.h"
#include "report/animation.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

int animate(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("FILE.svg"),
                        "the picture; default DIR/motion.svg")(
      "point", po::value<std::string>()->default_value("0")->value_name("P"), "sweep point");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const std::uint64_t point = whole_number(line.text("point"), "--point", 0);
  const fs::path result = finished_result(line.words[0]);
  const fs::path file = line.has("output") ? fs::path(line.text("output")) : result / "motion.svg";
  const SqliteReader database(result / "results.db");
  StoredPaths stored(database);
  std::vector<StoredPath> paths;
  do paths = stored.next_point();
  while (!paths.empty() && static_cast<std::uint64_t>(paths.front().point) != point);
  const std::string picture =
      animation_of(database, paths, fmt::format("{}, point {}", line.words[0], point));
  if (picture.empty())
    throw InputError(fmt::format(
        "no path of point {} is stored; output.trajectories of the scenario says how many are", point));
  write_file(file, picture);
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace flyrock::cli
