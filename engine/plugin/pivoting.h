#pragma once
// The resistance of ground to pivoting, for a law that says only what resists rolling.

namespace flyrock {

/// The bound mu_spin [m] of the torque about the normal where only mu_r [m], the bound of the rolling torque,
/// is given: 2/5 of it. The same patch of contact bears both torques. Let its pressure p(r) be the same in
/// all directions from its centre, with the sum r_n. The torque against rolling is greatest if the front half
/// bears all of r_n, with the pressure 2 p:
///   mu_r r_n <= integral of 2 p x over the front half = 4 S,   S = integral of p r^2 dr
/// Pivoting slides the whole patch about its centre, with the friction mu:
///   mu_spin r_n = integral of mu p r over the patch = 2 pi mu S
/// Thus mu_spin >= (pi/2) mu mu_r, whatever the pressure. 2/5 is that bound for mu = 0.25, and ground has
/// more. A greater mu_spin hardly changes where a rock stops, because it pivots on its place.
inline constexpr double usual_mu_spin(double mu_r) { return 0.4 * mu_r; }

}  // namespace flyrock
