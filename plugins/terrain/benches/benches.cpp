#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

constexpr double plateau = 50;  // m of berm behind the uppermost crest

class Benches : public TerrainModel {
 public:
  explicit Benches(Params& params)
      : count_(params.slot("count")),
        height_(params.slot("height")),
        face_angle_(params.slot("face_angle")),
        berm_(params.slot("berm")),
        floor_(params.slot("floor")) {
    params.require_dimension(2);
  }

  Profile build(Values values, RandomStream&) const override {
    const double count = values[count_], height = values[height_], angle = values[face_angle_];
    const double length = values[floor_], berm = values[berm_];
    require(count >= 1, "count", count, "at least 1");
    require(height > 0, "height", height, "above 0 m");
    require(angle > 0 && angle <= pi / 2 * (1 + 1e-12), "face_angle", angle, "above 0 and at most pi/2 rad");
    require(berm >= 0, "berm", berm, "at least 0 m");
    require(length > 0, "floor", length, "above 0 m");

    enum Part { face, berm_part, floor_part };
    Profile profile;
    profile.parts = {"face", "berm", "floor"};
    const int benches = static_cast<int>(std::lround(count));
    const double run = height * std::max(0.0, std::cos(angle)) / std::sin(angle);
    const auto go_to = [&profile](const Vec2& point, Part part) {
      profile.points.push_back(point);
      profile.part.push_back(part);
    };
    profile.points.emplace_back(-plateau, benches * height);
    go_to({0, benches * height}, berm_part);
    for (int below = benches - 1; below >= 0; --below) {
      const Vec2 crest = profile.points.back();
      const Vec2 toe(crest.x() + run, below * height);
      go_to(toe, face);
      profile.faces.push_back({toe, crest});
      if (below > 0 && berm > 0) go_to(toe + Vec2(berm, 0), berm_part);
    }
    go_to(profile.points.back() + Vec2(length, 0), floor_part);
    return profile;
  }

 private:
  static void require(bool fine, const char* name, double value, const char* expected) {
    if (!fine)
      throw PluginError(fmt::format("plugin benches: {} is {:.6g}, must be {}", name, value, expected));
  }

  int count_, height_, face_angle_, berm_, floor_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_benches(Params& params) { return std::make_unique<Benches>(params); }

}  // namespace flyrock::plugins
