#include <fmt/format.h>

#include "geometry/contactor.h"
#include "geometry/pneumatic.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

/// A disk or hollow disk whose radius moves.
class PneumaticDisk : public ShapeModel {
 public:
  PneumaticDisk(Params& params, bool hollow)
      : hollow_(hollow),
        radius_(params.slot("radius")),
        pressure_(params.slot("pressure")),
        outside_(params.slot("outside")),
        gamma_(params.slot("gamma")),
        stiffness_(params.slot("stiffness")),
        damping_(params.slot("damping")),
        radial_mass_(params.slot("radial_mass")) {
    params.require_dimension(2);
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    constexpr double wall = 1.05;  // outer radius as a share of the inner one
    const double radius = values[radius_];
    return {hollow_ ? Contactor2::hollow_disk(radius, wall * radius) : Contactor2::disk(radius)};
  }

  ShapeAnswer<2> shape(Values values, RandomStream& rng) const override {
    Pneumatic filling{.pressure = values[pressure_],
                      .outside = values[outside_],
                      .gamma = values[gamma_],
                      .stiffness = values[stiffness_],
                      .damping = values[damping_],
                      .radial_mass = {}};
    if (radial_mass_ >= 0) filling.radial_mass = values[radial_mass_];
    return {build(values, rng), {}, filling};
  }

 private:
  bool hollow_;
  int radius_, pressure_, outside_, gamma_, stiffness_, damping_, radial_mass_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_pneumatic_disk(Params& params) {
  return std::make_unique<PneumaticDisk>(params, false);
}
std::unique_ptr<ShapeModel> make_pneumatic_hollow_disk(Params& params) {
  return std::make_unique<PneumaticDisk>(params, true);
}

}  // namespace flyrock::plugins
