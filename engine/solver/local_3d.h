#pragma once
// Exact solution of one contact in 3D, with the impulses of all others fixed.

#include "solver/contact_problem.h"

namespace flyrock {

/// A contact with friction only, prepared once for many solves:
///   u = b + W r,   0 <= u_n _|_ r_n >= 0,   |r_t| <= mu r_n.
///
/// No contact if b_n >= 0; stick if r = -W^-1 b lies in the cone. Otherwise the contact slides: u_n = 0 and
/// u_t = -lambda r_t with lambda >= 0. By Cramer's rule, r is then proportional to polynomials in lambda,
///   N_n = n_0 + n_1 lambda - b_n lambda^2,   N_t = p_0 + p_1 lambda,
/// and lambda solves the quartic |N_t|^2 = mu^2 N_n^2 with N_n > 0. For a positive definite W a root is
/// bracketed:
/// N_t| - mu N_n is positive at lambda = 0 (or at the largest zero of N_n) and negative for large lambda.
/// Newton steps on the angle of r_t then refine its direction d to rounding,
///   g = d' . (b_t + r_n (W_tn + mu W_tt d)) = 0,   r_n = -b_n / (W_nn + mu W_nt d),   d' normal to d,
/// If the contact slid before, these Newton steps alone suffice, started from the old direction.
class FrictionContact3 {
 public:
  FrictionContact3() = default;
  FrictionContact3(const Eigen::Matrix3d& w, double mu);

  /// The impulse for the velocity b due to all other contacts. `guess`: the last answer, or zero.
  Eigen::Vector3d solve(const Eigen::Vector3d& b, const Eigen::Vector3d& guess) const;

 private:
  bool stick(const Eigen::Vector3d& b, Eigen::Vector3d& r) const;
  bool slide_from(const Eigen::Vector2d& direction, const Eigen::Vector3d& b, Eigen::Vector3d& r) const;
  Eigen::Vector2d bracketed_direction(const Eigen::Vector3d& b) const;

  Eigen::Matrix3d w_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Zero();  ///< the pseudo-inverse if the block is singular
  bool singular_ = false;
  double mu_ = 0;
};

/// The impulse of one contact with u = b + W r. Friction only: as above; otherwise solve_bounded.
ContactProblem<3>::Row solve_local(const ContactProblem<3>::Contact& contact, const ContactProblem<3>::Row& b,
                                   const ContactProblem<3>::Row& guess);

/// The impulse of a contact with cohesion, rolling resistance or spinning resistance. Newton's method solves
/// u_n = 0 and x_g = P(x_g - rho u_g) for each group g of rows, starting from `guess`. If it fails, a bracket
/// on r_n is used: for given r_n, the bounded rows minimise a convex function over discs (coordinate descent
/// over the groups). For a positive definite W, u_n is negative at r_n = 0 and positive for large r_n.
ContactProblem<3>::Row solve_bounded(const ContactProblem<3>::Contact& contact,
                                     const ContactProblem<3>::Row& b, const ContactProblem<3>::Row& guess);

}  // namespace flyrock
