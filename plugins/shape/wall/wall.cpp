#include <fmt/format.h>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Wall : public ShapeModel {
 public:
  explicit Wall(Params& params) : length_(params.slot("length")), radius_(params.slot("radius")) {
    params.require_dimension(2);
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const double length = values[length_], radius = values[radius_];
    if (!(length > 0 && radius > 0))
      throw PluginError(fmt::format(
          "plugin wall: length is {:.6g} m and radius {:.6g} m, both must be above 0", length, radius));
    const Vec2 end(length / 2, 0);
    return {Contactor2::wall(-end, end, radius)};
  }

 private:
  int length_, radius_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_wall(Params& params) { return std::make_unique<Wall>(params); }

}  // namespace flyrock::plugins
