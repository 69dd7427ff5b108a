#pragma once
// The launch speed of the burden from the energy of its charge (Gurney; Roth 1979 for benches).

#include "blast/blast.h"

namespace flyrock {

/// The mass of charge divided by the mass of rock that it breaks out, per length of hole [1]:
///   c/m = (W/l) / (rho b^2 tan(alpha/2)),  W/l = pi/4 d^2 rho_e
/// with the burden b, breakout angle alpha, hole diameter d, densities rho of the rock and rho_e of the
/// explosive. Throws std::invalid_argument that names a field that is not positive, or an angle that is not
/// below pi. Source: J. Roth, A model for the determination of flyrock range, USBM J0387242 (1979).
double charge_to_mass(const Blast& blast);

/// Whether the breakout angle lies in the range for which the prism is given: 90 to 120 degrees (Roth 1979).
bool is_usual_breakout(const Blast& blast);

/// The largest c/m for which the mass of the gas is negligible compared with the rock. The forms of Gurney's
/// model then differ by 3 %.
inline constexpr double light_charge = 0.1;

/// The geometry for which Gurney's model distributes the energy of the explosive.
enum class GurneyGeometry {
  roth,      ///< f = sqrt(c/m): the gas takes no part of the energy
  cylinder,  ///< f = (m/c + 1/2)^-1/2
  sphere,    ///< f = (m/c + 3/5)^-1/2
  sandwich   ///< f = (m/c + 1/3)^-1/2
};

/// f(c/m) [1] in v0 = sqrt(2E) f(c/m), for c/m > 0. All forms tend to sqrt(c/m) for a small charge.
double gurney_factor(GurneyGeometry geometry, double charge_to_mass);

}  // namespace flyrock
