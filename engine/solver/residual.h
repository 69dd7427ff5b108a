#pragma once
// How far impulses are from a solution: two error measures, which are never mixed (docs/numerics.md).

#include <vector>

#include "solver/body_motions.h"
#include "solver/contact_problem.h"
#include "solver/solve_settings.h"

namespace flyrock {

/// The scaled local map of a contact in m/s: with rho = 1 / max diagonal of its n and t rows,
///   e_n = |r_n - max(0, r_n - rho u_n)| / rho,   e_t = |r_t - P(r_t - rho u_t)| / rho,
/// where P is the projection onto |r_t| <= mu r_n + c_t. Spinning and rolling rows are treated alike, with
/// their own bound and diagonal; the length sqrt(W_nn / W_gg) converts them to m/s. The result is the
/// greatest of these errors. It is zero exactly at a solution.
template <int D>
double local_error(const typename ContactProblem<D>::Contact& contact,
                   const typename ContactProblem<D>::Row& u, const typename ContactProblem<D>::Row& r);

/// The local error of contact a that rounding alone can cause [m/s]: 32 eps (|q| + sum |W_ab| |r_b|), over
/// the translational rows.
template <int D>
double rounding_error(const ContactProblem<D>& problem, int a,
                      const std::vector<typename ContactProblem<D>::Row>& r);

/// The norm of the natural map of the de Saxce form with rho = 1, over the rows in use:
///   F_a = r_a - P_K(r_a - (u_n + mu |u_t|, u_t)),   K = { |r_t| <= mu r_n }.
/// The merit is |F| / |q|; FCLIB's own merit is |F| / (1 + sqrt |q|). FCLIB has no cohesion, spinning or
/// rolling. With them the map is (r_n - max(0, r_n - u_n), r_g - P(r_g - u_g)) instead, which has the same
/// zeros.
struct Merit {
  double natural_map = 0;  ///< |F|
  double q = 0;            ///< |q|
  int worst_contact = -1;

  /// |F| / |q|; |F| if q is zero.
  double relative() const { return q > 0 ? natural_map / q : natural_map; }
  double fclib() const;
};
/// |F_a|^2 of one contact.
template <int D>
double natural_map_squared(const typename ContactProblem<D>::Contact& contact,
                           const typename ContactProblem<D>::Row& u,
                           const typename ContactProblem<D>::Row& r);
template <int D>
Merit merit(const ContactProblem<D>& problem, const std::vector<typename ContactProblem<D>::Row>& r);

/// Checks r by the error measure of `settings`. Fills converged, residual and worst_contact of `result`. If
/// the velocities that r gives to the bodies are given, those of contacts are taken from them.
template <int D>
void judge(const ContactProblem<D>& problem, const SolveSettings& settings,
           const std::vector<typename ContactProblem<D>::Row>& r, SolveResult& result,
           const std::vector<BodyMotion<D>>* motions = nullptr);

}  // namespace flyrock
