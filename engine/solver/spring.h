#pragma once
// The springs of the condition `penalty`, and how they enter the friction problem.

#include <cmath>

#include "plugin/contact_law.h"
#include "solver/restitution.h"

namespace flyrock {

/// d^(n-1) of an overlap d; 0 for an open contact.
inline double overlap_power(const Spring& spring, double d) {
  if (d <= 0) return 0;
  return spring.exponent == 1 ? 1 : std::pow(d, spring.exponent - 1);
}
/// The energy k d^(n+1) / (n+1) of an overlap d [J].
inline double elastic_energy(const Spring& spring, double d) {
  return spring.stiffness * overlap_power(spring, d) * d * d / (spring.exponent + 1);
}
/// The overlap at which a mass 1/w [kg] that meets the spring with the speed v [m/s] at the overlap d turns
/// round [m], without damper: k D^(n+1) / (n+1) = k d^(n+1) / (n+1) + v^2 / (2 w).
inline double turning_overlap(const Spring& spring, double d, double v, double w) {
  const double energy = elastic_energy(spring, d) + 0.5 * v * v / w;
  return std::pow((spring.exponent + 1) * energy / spring.stiffness, 1 / (spring.exponent + 1));
}

/// The weight of the velocity at the end of a step in the mean velocity by which a damper acts, for its decay
/// X = h c d^(n-1) W_nn: nearly 1/2 for a weak damper. With it, a damper alone is exact: u = e^-X v^-.
inline double damper_weight(double decay) {
  constexpr double small = 1e-2;  // for which the series errs by less than 1e-14
  if (decay < small) return 0.5 + decay / 12 - decay * decay * decay / 720;
  return -1 / std::expm1(-decay) - 1 / decay;
}

/// Makes contact a of a problem a spring, in a step of length h [s] (0: an impact, in which a spring does
/// nothing). `d` [m] is the overlap in the middle of the step, `stretch` [m] the one of the tangential spring
/// there, in the tangents of the contact. The spring pushes with h k d^n: without damper a given impulse. A
/// damper acts by the mean v_m = (1 - y) v^- + y u of the velocities at both ends of the step, with its
/// weight y,
///   r_n = max(0, h (k d^n - c d^(n-1) v_m)),
/// which is Signorini's condition for a row of the problem: with x = y h c d^(n-1) W_nn,
///   0 <= r_n _|_ W_nn r_n + (x (W_nt r_t + couplings + q_n + (1/y - 1) v^-) - h k d^n W_nn) / (1 + x) >= 0.
/// A tangential spring is friction on the row W_tt (r_t + h k_t s): it sticks at r_t = -h k_t s.
template <int D>
void set_spring(const Spring& spring, double d, const Eigen::Matrix<double, D - 1, 1>& stretch, double h,
                ContactProblem<D>& problem, int a, Rebound<D>& rebound) {
  auto& contact = problem.contacts[a];
  const double power = overlap_power(spring, d), shear_strength = contact.c_t;
  const double push = h * spring.stiffness * (power * d);
  const double w = contact.w(0, 0), decay = h * spring.damping * power * w;
  const double weight = damper_weight(decay), x = weight * decay;
  static_cast<Restitution&>(rebound) = {};  // of a spring only the damper takes energy
  contact.normal = x > 0;
  rebound.given = contact.normal ? 0 : push;
  contact.bound_from(rebound.given, shear_strength);
  if (contact.normal) {
    const double share = x / (1 + x);
    contact.w.row(0) *= share;
    contact.w(0, 0) = w;
    contact.q[0] = share * (contact.q[0] + (1 / weight - 1) * rebound.before[0]) - push * w / (1 + x);
    problem.scale_couplings(a, 0, share);
  }
  if (spring.tangential_stiffness <= 0) return;
  constexpr int tangents = D - 1;
  const double w_t = contact.w.diagonal().template segment<tangents>(1).mean();
  contact.w.template middleRows<tangents>(1).setZero();
  contact.w.template block<tangents, tangents>(1, 1).diagonal().setConstant(w_t);
  contact.q.template segment<tangents>(1) = w_t * h * spring.tangential_stiffness * stretch;
  for (int row = 1; row <= tangents; ++row) problem.scale_couplings(a, row, 0);
}

}  // namespace flyrock
