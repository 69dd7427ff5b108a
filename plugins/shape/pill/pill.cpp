#include <fmt/format.h>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Pill : public ShapeModel {
 public:
  explicit Pill(Params& params) : length_(params.slot("length")), radius_(params.slot("radius")) {
    params.require_dimension(3);
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const double length = values[length_], radius = values[radius_];
    if (!(length > 0 && radius > 0))
      throw PluginError(fmt::format(
          "plugin pill: length is {:.6g} m and radius {:.6g} m, both must be above 0", length, radius));
    const Vec3 end(0, 0, length / 2);
    return {Contactor3::pill(-end, end, radius)};
  }

 private:
  int length_, radius_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_pill(Params& params) { return std::make_unique<Pill>(params); }

}  // namespace flyrock::plugins
