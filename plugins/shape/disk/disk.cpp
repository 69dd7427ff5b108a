#include <fmt/format.h>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Disk : public ShapeModel {
 public:
  explicit Disk(Params& params) : radius_(params.slot("radius")) { params.require_dimension(2); }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const double radius = values[radius_];
    if (!(radius > 0))
      throw PluginError(fmt::format("plugin disk: radius is {:.6g} m, must be above 0", radius));
    return {Contactor2::disk(radius)};
  }

 private:
  int radius_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_disk(Params& params) { return std::make_unique<Disk>(params); }

}  // namespace flyrock::plugins
