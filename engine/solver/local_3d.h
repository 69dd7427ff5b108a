#pragma once
// One contact in space, the others frozen: solved exactly.

#include "solver/contact_problem.h"

namespace flyrock {

/// A contact with friction alone, prepared once for many solves: u = b + W r, 0 <= u_n _|_ r_n >= 0, |r_t| <=
/// mu r_n.
///
/// No contact where b_n >= 0; stick where r = -W^-1 b lies in the cone. Else the contact slides: u_n = 0 and
/// u_t = -lambda r_t with lambda >= 0. By Cramer's rule r is then proportional to polynomials in lambda,
///   N_n = n_0 + n_1 lambda - b_n lambda^2,   N_t = p_0 + p_1 lambda,
/// and the multiplier solves the quartic |N_t|^2 = mu^2 N_n^2 with N_n > 0. For a positive definite W a root
/// is bracketed: |N_t| - mu N_n is positive at lambda = 0 (or at the largest zero of N_n) and negative far
/// out. The direction d of r_t is then sharpened to rounding by Newton steps on its angle,
///   g = d' . (b_t + r_n (W_tn + mu W_tt d)) = 0,   r_n = -b_n / (W_nn + mu W_nt d),   d' normal to d,
/// which also serve alone where the contact slid before: its old direction is the start.
class FrictionContact3 {
 public:
  FrictionContact3() = default;
  FrictionContact3(const Eigen::Matrix3d& w, double mu);

  /// The impulse for the velocity b that the others leave; `guess`: the last answer, or zero.
  Eigen::Vector3d solve(const Eigen::Vector3d& b, const Eigen::Vector3d& guess) const;

 private:
  bool stick(const Eigen::Vector3d& b, Eigen::Vector3d& r) const;
  bool slide_from(const Eigen::Vector2d& direction, const Eigen::Vector3d& b, Eigen::Vector3d& r) const;
  Eigen::Vector2d bracketed_direction(const Eigen::Vector3d& b) const;

  Eigen::Matrix3d w_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Zero();  ///< of a singular block: the pseudo-inverse
  bool singular_ = false;
  double mu_ = 0;
};

/// The impulse of one contact with u = b + W r, whatever it has: friction alone as above, else solve_bounded.
ContactProblem<3>::Row solve_local(const ContactProblem<3>::Contact& contact, const ContactProblem<3>::Row& b,
                                   const ContactProblem<3>::Row& guess);

/// A contact with cohesion, or that resists rolling or spinning. Found by Newton's method on u_n = 0 and
/// x_g = P(x_g - rho u_g) for each group g of rows, from `guess`; where that fails, by a bracket on r_n:
/// given r_n, the rows in bounds minimise a convex function over discs (coordinate descent over the groups),
/// and u_n is negative at r_n = 0 and positive far out for a positive definite W.
ContactProblem<3>::Row solve_bounded(const ContactProblem<3>::Contact& contact,
                                     const ContactProblem<3>::Row& b, const ContactProblem<3>::Row& guess);

}  // namespace flyrock
