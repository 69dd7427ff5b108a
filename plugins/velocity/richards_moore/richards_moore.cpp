#include "blast/richards_moore.h"

#include <cmath>

#include "plugins/factories.h"
#include "plugins/velocity/aim.h"

namespace flyrock::plugins {

namespace {

RichardsMooreMode mode_of(const std::string& name) {
  if (name == "face_burst") return RichardsMooreMode::face_burst;
  if (name == "cratering") return RichardsMooreMode::cratering;
  if (name == "stemming_ejection") return RichardsMooreMode::stemming_ejection;
  throw PluginError("plugin richards_moore: the mode `" + name + "` is not known");
}

class RichardsMoore : public VelocityModel {
 public:
  explicit RichardsMoore(Params& params)
      : mode_(mode_of(params.text("mode"))),
        k_(params.slot("k")),
        drill_angle_(params.slot("drill_angle")),
        aim_(params, "richards_moore") {
    const bool along_the_hole = mode_ == RichardsMooreMode::stemming_ejection;
    if (along_the_hole && drill_angle_ < 0)
      throw PluginError("plugin richards_moore: `drill_angle` is missing, stemming leaves along the hole");
    if (along_the_hole && aim_.given_elevation())
      throw PluginError(
          "plugin richards_moore: stemming leaves at `drill_angle`; `elevation` is of the other modes");
    if (!along_the_hole && drill_angle_ >= 0)
      throw PluginError("plugin richards_moore: `drill_angle` is of the mode stemming_ejection only");
  }

  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream&) const override {
    const double k = values[k_];
    const double speed =
        of_the_blast("richards_moore", [&] { return richards_moore_speed(mode_, k, blast); });
    const bool along_the_hole = mode_ == RichardsMooreMode::stemming_ejection;
    Launch launch;
    launch.velocity = along_the_hole ? aim_.velocity_at(values, rock, speed, values[drill_angle_])
                                     : aim_.velocity(values, rock, speed);
    launch.greatest_throw =
        speed * speed / range_gravity * (along_the_hole ? std::abs(std::sin(2 * values[drill_angle_])) : 1);
    if (k < 13.5 || k > 30)
      launch.note = "richards_moore: k lies outside 13.5 to 30, the range in which it is used";
    return launch;
  }

 private:
  RichardsMooreMode mode_;
  int k_, drill_angle_;
  Aim aim_;
};

}  // namespace

std::unique_ptr<VelocityModel> make_richards_moore(Params& params) {
  return std::make_unique<RichardsMoore>(params);
}

}  // namespace flyrock::plugins
