#include <fmt/format.h>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Sphere : public ShapeModel {
 public:
  explicit Sphere(Params& params) : radius_(params.slot("radius")) { params.require_dimension(3); }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const double radius = values[radius_];
    if (!(radius > 0))
      throw PluginError(fmt::format("plugin sphere: radius is {:.6g} m, must be above 0", radius));
    return {Contactor3::sphere(radius)};
  }

 private:
  int radius_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_sphere(Params& params) { return std::make_unique<Sphere>(params); }

}  // namespace flyrock::plugins
