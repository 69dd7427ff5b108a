// flyrock animate: the motion of the stored rocks as an animated picture, as a film, or as single frames.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/film.h"
#include "cli/result_folder.h"
#include "files/safe_file.h"
#include "report/pictures/animation.h"
#include "units/units.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The title of the scenario of a result.
std::string title_of(const fs::path& result) {
  return nlohmann::json::parse(read_file(result / "summary.json")).at("title").get<std::string>();
}

double time_of(const std::string& option, const std::string& text) {
  const std::optional<Quantity> read = parse_quantity(text);
  if (!read || !(read->si() > 0) || (read->has_unit && read->unit.dimension != dimension::time))
    throw UsageError(fmt::format("--{} {}: expected a positive time, as `12 s`", option, text));
  return read->si();
}

/// "X0,Y0,X1,Y1" in m.
Region region_of(const std::string& text) {
  std::vector<double> numbers;
  std::string word;
  for (std::istringstream words(text); std::getline(words, word, ',');) {
    const std::optional<Quantity> read = parse_quantity(word);
    if (!read || (read->has_unit && read->unit.dimension != dimension::length)) break;
    numbers.push_back(read->si());
  }
  const auto n = std::count(text.begin(), text.end(), ',');
  if (n != 3 || numbers.size() != 4 || !(numbers[0] < numbers[2]) || !(numbers[1] < numbers[3]))
    throw UsageError(
        fmt::format("--region {}: expected X0,Y0,X1,Y1 in m with X0 < X1 and Y0 < Y1, as `0,0,40,12`", text));
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

ForceStyle style_of(const std::string& word) {
  if (word == "arrows") return ForceStyle::arrows;
  if (word == "network") return ForceStyle::network;
  throw UsageError(fmt::format("--forces {}: expected `arrows` or `network`", word));
}

bool comes_to(const Region& region, const std::vector<StoredPath>& paths) {
  return std::any_of(paths.begin(), paths.end(), [&](const StoredPath& path) {
    return std::any_of(path.moments.begin(), path.moments.end(), [&](const StoredMoment& moment) {
      const Vec2 place = moment.place.head<2>();
      return region.overlaps(Box2{place, place});
    });
  });
}

/// Cuts the paths at a time [s]. A path that begins later ends where it begins.
void end_at(std::vector<StoredPath>& paths, double time) {
  for (StoredPath& path : paths) {
    if (path.moments.back().time <= time) continue;
    StoredMoment last = path.at(time);
    last.time = std::max(time, path.moments.front().time);
    std::erase_if(path.moments, [&](const StoredMoment& moment) { return moment.time >= last.time; });
    path.moments.push_back(last);
  }
}

}  // namespace

int animate(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("FILE"),
                        "FILE.svg, or for slides FILE.mp4, FILE.gif, or FILE.png: a picture a frame, as "
                        "FILE-001.png; default DIR/motion.svg")(
      "point", po::value<std::string>()->default_value("0")->value_name("P"), "sweep point")(
      "until", po::value<std::string>()->value_name("TIME"),
      "where the motion ends, as `12 s`; default: all")("at", po::value<std::string>()->value_name("TIME"),
                                                        "one picture, of this time")(
      "region", po::value<std::string>()->value_name("X0,Y0,X1,Y1"),
      "what of the scene is seen, in m (3D: in plan); default: all that the rocks pass")(
      "forces", po::value<std::string>()->value_name("arrows|network"),
      "how forces of contacts are drawn, where the results have a series: as arrows (default), or as the "
      "force network, lines from centre to centre that are wider for greater forces")(
      "width", po::value<std::string>()->default_value("1280")->value_name("PIXELS"), "of films and of PNG");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const std::uint64_t point = whole_number(line.text("point"), "--point", 0);
  const std::uint64_t width = whole_number(line.text("width"), "--width", 16);
  const fs::path result = finished_result(line.words[0]);
  const fs::path file = line.has("output") ? fs::path(line.text("output")) : result / "motion.svg";
  std::optional<double> at;
  std::optional<Region> region;
  const ForceStyle style = line.has("forces") ? style_of(line.text("forces")) : ForceStyle::arrows;
  if (line.has("region")) region = region_of(line.text("region"));
  if (line.has("at")) at = time_of("at", line.text("at"));
  if (at && is_film(file) && file.extension() != ".png")
    throw UsageError("--at gives one picture: expected -o FILE.svg or FILE.png");
  if (is_film(file)) require_programs(file);
  const SqliteReader database(result / "results.db");
  StoredPaths stored(database);
  std::vector<StoredPath> paths;
  do paths = stored.next_point();
  while (!paths.empty() && static_cast<std::uint64_t>(paths.front().point) != point);
  if (paths.empty())
    throw InputError(fmt::format(
        "no path of point {} is stored; output.trajectories of the scenario says how many are", point));
  if (line.has("until")) end_at(paths, time_of("until", line.text("until")));
  if (region && !comes_to(*region, paths))
    throw InputError(fmt::format("--region {}: no stored rock comes there", line.text("region")));
  const std::string title = fmt::format("{}, point {}", title_of(result), point);
  if (is_film(file)) {
    film(frames_of(database, paths, title, at, region, style), file, width);
    return done;
  }
  write_file(file, at ? frames_of(database, paths, title, at, region, style).pictures.front()
                      : animation_of(database, paths, title, region, style));
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace flyrock::cli
