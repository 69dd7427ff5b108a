#include <cmath>
#include <numbers>

#include "plugin/module.h"

namespace {

/// Speed that falls with the burden over the root of the charge per metre, v = k (sqrt(W/l)/b)^1.3.
class MyLaunch : public flyrock::VelocityModel {
 public:
  explicit MyLaunch(flyrock::Params& params) : k_(params.slot("k")), elevation_(params.slot("elevation")) {}
  flyrock::Launch launch(flyrock::Values values, const flyrock::RockView& rock, const flyrock::Blast& blast,
                         flyrock::RandomStream&) const override {
    using enum flyrock::BlastField;
    const double charge = std::numbers::pi / 4 * std::pow(blast[hole_diameter], 2) * blast[explosive_density];
    const double speed = values[k_] * std::pow(std::sqrt(charge) / blast[burden], 1.3);
    flyrock::Launch launch;
    launch.velocity = flyrock::direction_velocity(rock, speed, values[elevation_]);
    return launch;
  }

 private:
  int k_, elevation_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::velocity, "my_launch"}] = flyrock::FactoryOf<flyrock::VelocityModel>(
      [](flyrock::Params& params) { return std::make_unique<MyLaunch>(params); });
  return nullptr;
}
