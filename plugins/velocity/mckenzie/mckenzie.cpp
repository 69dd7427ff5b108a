#include "blast/mckenzie.h"

#include <cmath>

#include "plugins/factories.h"
#include "plugins/velocity/aim.h"

namespace flyrock::plugins {

namespace {

class McKenzie : public VelocityModel {
 public:
  explicit McKenzie(Params& params) : aim_(params, "mckenzie") {}

  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream&) const override {
    const double depth = of_the_blast("mckenzie", [&] { return scaled_depth_of_burial(blast); });
    const double range = mckenzie_range(depth, blast[BlastField::hole_diameter]);
    Launch launch;
    launch.velocity = aim_.velocity(values, rock, std::sqrt(range_gravity * range));
    launch.greatest_throw = range;
    if (depth < least_depth)
      launch.note = "mckenzie: the scaled depth of burial is below 0.64 m/kg^(1/3), where blasts are violent";
    return launch;
  }

 private:
  static constexpr double least_depth = 0.64;  // m/kg^(1/3)
  Aim aim_;
};

}  // namespace

std::unique_ptr<VelocityModel> make_mckenzie(Params& params) { return std::make_unique<McKenzie>(params); }

}  // namespace flyrock::plugins
