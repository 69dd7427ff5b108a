#include <fmt/format.h>

#include <cmath>

#include "geometry/profile.h"
#include "geometry/terrain_shape.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

constexpr double half_length = 1000;  // m, half length of the profile that represents the plane in 2D

class PlaneTerrain : public TerrainModel {
 public:
  explicit PlaneTerrain(Params& params)
      : point_(params.vector_slot("point")), normal_(params.vector_slot("normal")) {}

  Profile build(Values values, RandomStream&) const override {
    const Vec2 point = point_of<2>(values), normal = normal_of<2>(values);
    const Vec2 slope = half_length / normal.y() * Vec2(normal.y(), -normal.x());
    Profile profile;
    profile.points = {point - slope, point + slope};
    profile.part = {0};
    profile.parts = {""};
    return profile;
  }

  TerrainShape3 build_3d(Values values, RandomStream&) const override {
    Plane plane;
    plane.point = point_of<3>(values);
    plane.normal = normal_of<3>(values);
    return plane;
  }

 private:
  template <int D>
  Vec<D> point_of(Values values) const {
    return point_ < 0 ? Vec<D>(Vec<D>::Zero()) : Vec<D>(Eigen::Map<const Vec<D>>(values.data() + point_));
  }

  /// The unit normal, upwards; the ground is below the plane.
  template <int D>
  Vec<D> normal_of(Values values) const {
    if (normal_ < 0) return Vec<D>::Unit(D - 1);
    const Vec<D> normal = Eigen::Map<const Vec<D>>(values.data() + normal_);
    const double length = normal.stableNorm(), rise = std::abs(normal[D - 1]);
    if (!(length > 1e-100 && length < 1e100))
      throw PluginError(fmt::format(
          "plugin plane: its normal has the length {:.6g}, expected one that is neither zero nor immense",
          length));
    if (!(rise > 1e-6 * length))
      throw PluginError(
          fmt::format("plugin plane: its normal has the vertical component {:.6g} of a length of {:.6g}: the "
                      "plane stands upright and has no ground below",
                      normal[D - 1], length));
    return std::copysign(1 / length, normal[D - 1]) * normal;
  }

  int point_, normal_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_plane(Params& params) { return std::make_unique<PlaneTerrain>(params); }

}  // namespace flyrock::plugins
