#pragma once
// The direction of a launch, which the velocity models share.

#include <string>

#include "plugin/models.h"
#include "plugins/of_the_blast.h"

namespace flyrock::plugins {

/// The direction of a launch from the parameters `elevation` and, in 3D, `azimuth`.
class Aim {
 public:
  Aim(Params& params, const std::string& plugin)
      : elevation_(params.slot("elevation")), azimuth_(params.slot("azimuth")) {
    if (azimuth_ >= 0 && params.dimension() == 2)
      throw PluginError("plugin " + plugin +
                        ": `azimuth` turns a launch about the vertical, which needs dimension 3");
  }

  /// Whether the scenario gives its own direction.
  bool given() const { return given_elevation() || azimuth_ >= 0; }

  bool given_elevation() const { return elevation_ >= 0; }

  /// The velocity at the elevation of the scenario, or at 45 degrees, the default of every model.
  Vec3 velocity(Values values, const RockView& rock, double speed) const {
    return velocity_at(values, rock, speed, given_elevation() ? values[elevation_] : pi / 4);
  }

  /// The velocity at an elevation [rad] from the model, turned by the azimuth of the scenario.
  Vec3 velocity_at(Values values, const RockView& rock, double speed, double elevation) const {
    return direction_velocity(rock, speed, elevation, azimuth_ < 0 ? 0 : values[azimuth_]);
  }

 private:
  int elevation_, azimuth_;
};

}  // namespace flyrock::plugins
