#include "geometry/profile.h"

#include <fmt/format.h>

#include "plugins/factories.h"
#include "plugins/read_points.h"

namespace flyrock::plugins {

namespace {

[[noreturn]] void fail(const std::string& text) { throw PluginError("plugin profile: " + text); }

class ProfileTerrain : public TerrainModel {
 public:
  explicit ProfileTerrain(Params& params) {
    params.require_dimension(2);
    profile_.points = params.points2("points");
    const std::string file = params.text("file");
    if (params.given("points") == params.given("file")) fail("expected either `points` or a `file`");
    if (params.given("file"))
      for (const auto& point : read_points("profile", file, 2))
        profile_.points.emplace_back(point[0], point[1]);
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
