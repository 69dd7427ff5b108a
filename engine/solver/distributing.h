#pragma once
// The law of Liu, Zhao and Brogliato for impacts of several contacts at once.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// A place on the path of an impact: the impulses P_j [N s] and the normal velocities v = v^- + W P [m/s] of
/// its contacts, and the energies E_j [J] that their springs store.
struct DistributingPoint {
  Eigen::VectorXd impulse, velocity, energy;
  int primary = 0;  ///< the contact that stores the most
};

/// The springs of the contacts, F_j = K_j d^exponent.
struct DistributingSprings {
  double exponent = 1.5;        ///< 1.5: Hertz; 1: linear
  Eigen::VectorXd stiffness;    ///< only ratios matter
  Eigen::VectorXd restitution;  ///< energetic coefficients, above 0
};

/// Follows the energies of the contacts along the impulse P_i of the primary contact i:
///   dP_j / dP_i = (K_j / K_i)^(1/(n+1)) (E_j / E_i)^(n/(n+1)),  with the exponent n of the springs,
///   dE_j = -v_j dP_j in compression (v_j < 0),  -v_j dP_j / e_j^2 in expansion.
/// The path ends where no contact stores energy or approaches. Neither time nor the size of the stiffnesses
/// is in the equations, so that the result is a law of impact; without losses it is that of the springs. In
/// place of E_j the integration has y_j = E_j^(1/(n+1)), in which the equations are regular where E_j = 0 (an
/// equal number of steps of Runge and Kutta of fourth order, `steps` in the longest impact of one contact
/// alone). `w`: the normal rows of W, 1/kg; `v`: v^-. Throws std::runtime_error if the path does not end.
/// Source: C. Liu, Z. Zhao, B. Brogliato, Frictionless multiple impacts in multibody systems I, Proc. R. Soc.
/// A 464 (2008).
std::vector<DistributingPoint> distributing_path(const Eigen::MatrixXd& w, const Eigen::VectorXd& v,
                                                 const DistributingSprings& springs, int steps = 2000);

}  // namespace flyrock
