#include "geometry/cone.h"

#include <fmt/format.h>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Cone : public ShapeModel {
 public:
  explicit Cone(Params& params) : radius_(params.slot("radius")), height_(params.slot("height")) {
    params.require_dimension(3);
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const double radius = values[radius_], height = values[height_];
    if (!(radius > 0 && height > 0))
      throw PluginError(fmt::format(
          "plugin cone: radius is {:.6g} m and height {:.6g} m, both must be above 0", radius, height));
    return {flyrock::cone(radius, height)};
  }

 private:
  int radius_, height_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_cone(Params& params) { return std::make_unique<Cone>(params); }

}  // namespace flyrock::plugins
