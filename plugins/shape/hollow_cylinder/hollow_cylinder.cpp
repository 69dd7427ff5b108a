#include <fmt/format.h>

#include "geometry/contactor3.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class HollowCylinder : public ShapeModel {
 public:
  explicit HollowCylinder(Params& params)
      : radius_(params.slot("radius")), outer_(params.slot("outer")), height_(params.slot("height")) {
    params.require_dimension(3);
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const double radius = values[radius_], outer = outer_ < 0 ? 1.05 * radius : values[outer_],
                 height = values[height_];
    if (!(radius > 0 && outer > radius && height > 0))
      throw ParameterError(
          fmt::format("plugin hollow_cylinder: radius is {:.6g} m, outer {:.6g} m and height "
                      "{:.6g} m, expected 0 < radius < outer and a height above 0",
                      radius, outer, height));
    return {Contactor3::hollow_cylinder(radius, outer, height)};
  }

 private:
  int radius_, outer_, height_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_hollow_cylinder(Params& params) {
  return std::make_unique<HollowCylinder>(params);
}

}  // namespace flyrock::plugins
