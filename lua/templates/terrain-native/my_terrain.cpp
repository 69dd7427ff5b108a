#include "plugin/module.h"

namespace {

/// A level, a slope of 45 degrees and a level.
class MyTerrain : public flyrock::TerrainModel {
 public:
  explicit MyTerrain(flyrock::Params& params) : drop_(params.slot("drop")) {}
  /// The corners from left to right, and the part of each segment.
  flyrock::Profile build(flyrock::Values values, flyrock::RandomStream&) const override {
    const double drop = values[drop_];
    flyrock::Profile profile;
    profile.points = {{-20, drop}, {0, drop}, {drop, 0}, {drop + 200, 0}};
    profile.part = {0, 0, 0};
    profile.parts = {""};
    return profile;
  }

 private:
  int drop_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::terrain, "my_terrain"}] = flyrock::FactoryOf<flyrock::TerrainModel>(
      [](flyrock::Params& params) { return std::make_unique<MyTerrain>(params); });
  return nullptr;
}
