#include "geometry/profile.h"

#include <fmt/format.h>

#include "plugins/factories.h"
#include "plugins/read_points.h"
#include "survey/surveyed_terrain.h"

namespace flyrock::plugins {

namespace {

[[noreturn]] void fail(const std::string& text) { throw PluginError("plugin profile: " + text); }

/// The heads that surveys have for the distance along a section and the height.
const std::vector<TableColumn>& profile_columns() {
  static const std::vector<TableColumn> columns = {
      {.name = "x",
       .dimension = dimension::length,
       .required = true,
       .also = {"distance", "dist", "station", "stationing", "chainage", "offset", "s", "d", "abscissa",
                "abstand", "distanz"},
       .is_common = false},  // an easting is no distance along the section, a northing no height
      {.name = "y",
       .dimension = dimension::length,
       .required = true,
       .also = {"z", "height", "h", "elevation", "elev", "level", "altitude", "hoehe", "cota"},
       .is_common = false}};
  return columns;
}

/// "4 points, 402.5 to 432.1 m", and which columns were not read.
std::string size_text(const PointFile& file) {
  const auto [low, high] = std::minmax_element(file.points.begin(), file.points.end(),
                                               [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return fmt::format(
      "{} points, {}{}", with_commas(file.points.size()), heights_text((*low)[1], (*high)[1]),
      file.other_heads.empty() ? "" : fmt::format(" (not read: `{}`)", fmt::join(file.other_heads, "`, `")));
}

class ProfileTerrain : public SurveyedTerrain {
 public:
  explicit ProfileTerrain(Params& params) {
    params.require_dimension(2);
    profile_.points = params.points2("points");
    const std::string file = params.text("file");
    if (params.given("points") == params.given("file")) fail("expected either `points` or a `file`");
    if (params.given("file")) read_file(file);
    profile_.part.assign(profile_.points.empty() ? 0 : profile_.points.size() - 1, 0);
    profile_.parts = {""};
    if (std::string fault = profile_.fault(); !fault.empty()) fail(fault);
  }

  Profile build(Values, RandomStream&) const override { return profile_; }
  SurveyReport report() const override { return report_; }

 private:
  void read_file(const std::string& path) {
    const PointFile file = read_points("profile", path, profile_columns());
    for (const std::vector<double>& point : file.points) profile_.points.emplace_back(point[0], point[1]);
    report_.size = size_text(file);
  }

  Profile profile_;
  SurveyReport report_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_profile(Params& params) {
  return std::make_unique<ProfileTerrain>(params);
}

}  // namespace flyrock::plugins
