#include "plugins/factories.h"
#include "plugins/velocity/aim.h"

namespace flyrock::plugins {

namespace {

class Fixed : public VelocityModel {
 public:
  explicit Fixed(Params& params)
      : components_(params.dimension()),
        velocity_(params.vector_slot("velocity")),
        speed_(params.slot("speed")),
        spin_(params.slot("spin")),
        aim_(params, "fixed") {
    if ((velocity_ < 0) == (speed_ < 0))
      throw PluginError("plugin fixed: expected either `velocity` or `speed`");
    if (velocity_ >= 0 && aim_.given())
      throw PluginError("plugin fixed: a direction goes with `speed`; `velocity` has its own");
  }

  Launch launch(Values values, const RockView& rock, const Blast&, RandomStream&) const override {
    Launch launch;
    if (components_ == 2)
      launch.spin.z() = values[spin_];
    else
      for (int i = 0; i < 3; ++i) launch.spin[i] = values[spin_ + i];
    if (speed_ >= 0)
      launch.velocity = aim_.velocity(values, rock, values[speed_]);
    else
      for (int i = 0; i < components_; ++i) launch.velocity[i] = values[velocity_ + i];
    return launch;
  }

 private:
  int components_, velocity_, speed_, spin_;
  Aim aim_;
};

}  // namespace

std::unique_ptr<VelocityModel> make_fixed(Params& params) { return std::make_unique<Fixed>(params); }

}  // namespace flyrock::plugins
