#pragma once
// What impulses do to the bodies of a problem that knows them (ContactProblem::sides).

#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// The velocities that impulses give to a body: v, then the spin.
template <int D>
using BodyMotion = Eigen::Matrix<double, Space<D>::dof, 1>;

/// Adds M^-1 H_a r of contact a to its bodies; N = width().
template <int N, int D>
void push_bodies(const ContactProblem<D>& problem, int a, const typename ContactProblem<D>::Row& r,
                 std::vector<BodyMotion<D>>& motions) {
  for (const auto& side : problem.sides[a])
    if (side.body >= 0)
      motions[side.body].noalias() += side.mobility.template leftCols<N>() * r.template head<N>();
}

/// v = sum of M^-1 H_b r_b.
template <int N, int D>
void find_motions(const ContactProblem<D>& problem, const std::vector<typename ContactProblem<D>::Row>& r,
                  std::vector<BodyMotion<D>>& motions) {
  motions.resize(static_cast<std::size_t>(problem.bodies));
  for (auto& motion : motions) motion.setZero();
  for (int a = 0; a < problem.size(); ++a) push_bodies<N>(problem, a, r[a], motions);
}

/// u_a = q_a + H_a^T v; rows beyond width() are copied from q.
template <int N, int D>
typename ContactProblem<D>::Row velocity_by(const ContactProblem<D>& problem, int a,
                                            const std::vector<BodyMotion<D>>& motions) {
  typename ContactProblem<D>::Row u = problem.contacts[a].q;
  for (const auto& side : problem.sides[a])
    if (side.body >= 0)
      u.template head<N>().noalias() += side.columns.template leftCols<N>().transpose() * motions[side.body];
  return u;
}

}  // namespace flyrock
