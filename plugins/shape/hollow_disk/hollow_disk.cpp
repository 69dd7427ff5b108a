#include <fmt/format.h>

#include "geometry/contactor.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class HollowDisk : public ShapeModel {
 public:
  explicit HollowDisk(Params& params) : radius_(params.slot("radius")), outer_(params.slot("outer")) {
    params.require_dimension(2);
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const double radius = values[radius_], outer = outer_ < 0 ? 1.05 * radius : values[outer_];
    if (!(radius > 0 && outer > radius))
      throw ParameterError(
          fmt::format("plugin hollow_disk: radius is {:.6g} m and outer {:.6g} m, expected "
                      "0 < radius < outer",
                      radius, outer));
    return {Contactor2::hollow_disk(radius, outer)};
  }

 private:
  int radius_, outer_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_hollow_disk(Params& params) { return std::make_unique<HollowDisk>(params); }

}  // namespace flyrock::plugins
