#include "verify/single_impact.h"

#include <cmath>

namespace flyrock {

namespace {

SingleOutcome outcome_of(const SingleImpact& impact, const Eigen::Vector2d& impulse) {
  const Eigen::Vector2d after = impact.v + impact.w * impulse;
  return {impulse, after, 0.5 * impulse.dot(impact.v + after)};
}

}  // namespace

Eigen::Matrix2d rod_mobility(double angle) {
  const double x = 0.5 * std::cos(angle), y = -0.5 * std::sin(angle), inertia = 1.0 / 12;
  Eigen::Matrix2d w;
  w << 1 + x * x / inertia, -x * y / inertia, -x * y / inertia, 1 + y * y / inertia;
  return w;
}

SingleOutcome solve_single(const SingleImpact& impact, RestitutionForm form, bool phases) {
  ContactProblem<2> problem;
  ContactProblem<2>::Contact contact;
  contact.w.setZero();
  contact.w.topLeftCorner<2, 2>() = impact.w;
  contact.q = {impact.v[0], impact.v[1], 0};
  contact.mu = impact.mu;
  contact.speed_scale = impact.v.norm();
  problem.contacts.push_back(contact);
  problem.first = {0, 0};
  if (phases) {  // coupled, by a block of zeros, to itself
    problem.couplings.push_back({0, ContactProblem<2>::Block::Zero()});
    problem.first[1] = 1;
  }
  Rebound<2> rebound;
  rebound.form = form;
  rebound.e_n = impact.e;
  rebound.before = contact.q;
  std::vector<ContactProblem<2>::Row> impulse(1, ContactProblem<2>::Row::Zero());
  ImpactSolver<2>().solve(problem, {rebound}, {1e-13, 1000}, impulse);
  return outcome_of(impact, impulse[0].head<2>());
}

SingleOutcome follow_single(const SingleImpact& impact, ImpactEnd end) {
  return outcome_of(impact, impact_path(impact.w, impact.v, impact.mu, end, impact.e));
}

}  // namespace flyrock
