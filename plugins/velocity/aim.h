#pragma once
// What the velocity models share: the direction of a launch, and the charge behind it.

#include <stdexcept>
#include <string>

#include "blast/gurney.h"
#include "plugin/models.h"

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

  /// Whether the scenario gives a direction of its own.
  bool given() const { return elevation_ >= 0 || azimuth_ >= 0; }

  Vec3 velocity(Values values, const RockView& rock, double speed) const {
    const double elevation = elevation_ < 0 ? 0 : values[elevation_];
    const double azimuth = azimuth_ < 0 ? 0 : values[azimuth_];
    return direction_velocity(rock, speed, elevation, azimuth);
  }

 private:
  int elevation_, azimuth_;
};

/// charge_to_mass with the plugin's name on what is wrong with the blast.
inline double charge_ratio(const Blast& blast, const std::string& plugin) {
  try {
    return charge_to_mass(blast);
  } catch (const std::invalid_argument& fault) {
    throw PluginError("plugin " + plugin + ": " + fault.what());
  }
}

}  // namespace flyrock::plugins
