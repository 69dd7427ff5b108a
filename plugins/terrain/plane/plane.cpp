#include <fmt/format.h>

#include <cmath>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class PlaneTerrain : public TerrainModel {
 public:
  explicit PlaneTerrain(Params& params)
      : point_(params.vector_slot("point")), normal_(params.vector_slot("normal")) {
    params.require_dimension(3);
  }

  Plane build_3d(Values values, RandomStream&) const override {
    const auto vector = [&](int slot, const Vec3& otherwise) {
      return slot < 0 ? otherwise : Vec3(values[slot], values[slot + 1], values[slot + 2]);
    };
    const Vec3 normal = vector(normal_, Vec3::UnitZ());
    const double length = normal.norm();
    if (!(std::abs(normal.z()) > 1e-6 * length))
      throw PluginError(fmt::format("plugin plane: its normal is [{:.6g}, {:.6g}, {:.6g}], must not be horizontal",
                                    normal.x(), normal.y(), normal.z()));
    Plane plane;
    plane.point = vector(point_, Vec3::Zero());
    plane.normal = normal / std::copysign(length, normal.z());  // out of the ground
    return plane;
  }

 private:
  int point_, normal_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_plane(Params& params) { return std::make_unique<PlaneTerrain>(params); }

}  // namespace flyrock::plugins
