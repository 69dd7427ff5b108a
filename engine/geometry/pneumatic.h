#pragma once
// What a pneumatic shape is filled with: the forces on its radius.

#include <optional>

namespace flyrock {

/// SI units; the equation is in world/breathing.h.
struct Pneumatic {
  double pressure = 0;                ///< Pa, absolute, at the radius that is given
  double outside = 0;                 ///< Pa
  double gamma = 0;                   ///< of the gas; 0: its pressure is constant
  double stiffness = 0;               ///< N/m, of the radius
  double damping = 0;                 ///< N s/m, of the radius
  std::optional<double> radial_mass;  ///< kg; left out: half of the mass, the whole one of a hollow disk
};

}  // namespace flyrock
