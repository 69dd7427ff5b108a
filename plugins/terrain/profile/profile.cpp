#include "geometry/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "plugins/factories.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

[[noreturn]] void fail(const std::string& text) { throw PluginError("plugin profile: " + text); }

/// The point that a line of a file gives, without its comment; nothing for an empty line.
std::optional<Vec2> read_point(std::string line, const std::string& where) {
  line.erase(std::min(line.find('#'), line.size()));
  const std::string text = line;
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const auto number = parse_number(word);
    if (!number) fail(fmt::format("{}: `{}` is not a number", where, word));
    numbers.push_back(*number);
  }
  if (numbers.empty() && text.find(',') == text.npos) return std::nullopt;
  if (numbers.size() != 2)
    fail(fmt::format("{}: expected two numbers, x and y, found {}", where, numbers.size()));
  return Vec2(numbers[0], numbers[1]);
}

std::vector<Vec2> read_points(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail(fmt::format("cannot read the file {}", path));
  std::vector<Vec2> points;
  int number = 0;
  for (std::string line; std::getline(file, line);)
    if (auto point = read_point(line, fmt::format("{}:{}", path, ++number))) points.push_back(*point);
  return points;
}

class ProfileTerrain : public TerrainModel {
 public:
  explicit ProfileTerrain(Params& params) {
    params.require_dimension(2);
    profile_.points = params.points2("points");
    const std::string file = params.text("file");
    if (params.given("points") == params.given("file")) fail("expected either `points` or a `file`");
    if (params.given("file")) profile_.points = read_points(file);
    profile_.part.assign(profile_.points.empty() ? 0 : profile_.points.size() - 1, 0);
    profile_.parts = {""};
    if (std::string fault = profile_.fault(); !fault.empty()) fail(fault);
  }

  Profile build(Values, RandomStream&) const override { return profile_; }

 private:
  Profile profile_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_profile(Params& params) {
  return std::make_unique<ProfileTerrain>(params);
}

}  // namespace flyrock::plugins
