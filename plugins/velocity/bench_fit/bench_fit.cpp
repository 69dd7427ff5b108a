#include "blast/bench_fit.h"

#include <algorithm>
#include <cmath>

#include "blast/gurney.h"
#include "plugins/factories.h"
#include "plugins/velocity/aim.h"

namespace flyrock::plugins {

namespace {

class BenchFitLaunch : public VelocityModel {
 public:
  explicit BenchFitLaunch(Params& params)
      : rock_(params.text("rock") == "granite" ? BenchRock::granite : BenchRock::limestone),
        form_(params.text("form") == "as_printed" ? BenchFitForm::as_printed : BenchFitForm::linear),
        aim_(params, "bench_fit") {}

  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream&) const override {
    const double ratio = of_the_blast("bench_fit", [&] { return charge_to_mass(blast); });
    const double squared = squared_speed(bench_fit(rock_, blast.is_anfo), form_, ratio);
    Launch launch;
    launch.velocity = aim_.velocity(values, rock, std::sqrt(std::max(squared, 0.0)));
    launch.note = note(blast, squared);
    return launch;
  }

 private:
  /// What the user must know about this speed, the most serious first.
  std::string note(const Blast& blast, double squared) const {
    if (squared < 0)
      return "bench_fit: v0^2 < 0, the charge is too small for the fit; the rock starts at rest";
    if (form_ == BenchFitForm::as_printed)
      return "bench_fit: form as_printed takes the square root of c/m; its speeds are those of no quarry";
    if (!is_usual_breakout(blast))
      return "bench_fit: the breakout angle lies outside 90 to 120 degrees, for which the prism is given";
    if (rock_ == BenchRock::limestone && !blast.is_anfo)
      return "bench_fit: the fit of limestone is printed for ANFO only and is used here for another "
             "explosive";
    return {};
  }

  BenchRock rock_;
  BenchFitForm form_;
  Aim aim_;
};

}  // namespace

std::unique_ptr<VelocityModel> make_bench_fit(Params& params) {
  return std::make_unique<BenchFitLaunch>(params);
}

}  // namespace flyrock::plugins
