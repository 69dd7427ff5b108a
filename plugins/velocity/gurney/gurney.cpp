#include "blast/gurney.h"

#include "plugins/factories.h"
#include "plugins/velocity/aim.h"

namespace flyrock::plugins {

namespace {

GurneyGeometry geometry_of(const std::string& name) {
  if (name == "roth") return GurneyGeometry::roth;
  if (name == "cylinder") return GurneyGeometry::cylinder;
  if (name == "sphere") return GurneyGeometry::sphere;
  if (name == "sandwich") return GurneyGeometry::sandwich;
  throw PluginError("plugin gurney: the geometry `" + name + "` is not known");
}

class Gurney : public VelocityModel {
 public:
  explicit Gurney(Params& params) : geometry_(geometry_of(params.text("geometry"))), aim_(params, "gurney") {}

  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream&) const override {
    const double ratio = of_the_blast("gurney", [&] { return charge_to_mass(blast); });
    const double factor = gurney_factor(geometry_, ratio);
    Launch launch;
    launch.velocity = aim_.velocity(values, rock, blast[BlastField::gurney_constant] * factor);
    if (!is_usual_breakout(blast))
      launch.note = "gurney: the breakout angle lies outside 90 to 120 degrees, for which the prism is given";
    else if (geometry_ == GurneyGeometry::roth && ratio > light_charge)
      launch.note =
          "gurney: c/m is above 0.1; with so much gas the geometries differ, and roth leaves the gas out";
    return launch;
  }

 private:
  GurneyGeometry geometry_;
  Aim aim_;
};

}  // namespace

std::unique_ptr<VelocityModel> make_gurney(Params& params) { return std::make_unique<Gurney>(params); }

}  // namespace flyrock::plugins
