#include "verify/single_impact.h"

#include <cmath>

namespace flyrock {

namespace {

template <int D>
SingleOutcome<D> outcome_of(const SingleImpact<D>& impact, const Eigen::Matrix<double, D, 1>& impulse) {
  const Eigen::Matrix<double, D, 1> after = impact.v + impact.w * impulse;
  return {impulse, after, 0.5 * impulse.dot(impact.v + after)};
}

}  // namespace

Eigen::Matrix2d rod_mobility(double angle) {
  const double x = 0.5 * std::cos(angle), y = -0.5 * std::sin(angle), inertia = 1.0 / 12;
  Eigen::Matrix2d w;
  w << 1 + x * x / inertia, -x * y / inertia, -x * y / inertia, 1 + y * y / inertia;
  return w;
}

template <int D>
SingleOutcome<D> solve_single(const SingleImpact<D>& impact, RestitutionForm form, bool phases) {
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;
  Problem problem;
  typename Problem::Contact contact;
  contact.w.setZero();
  contact.w.template topLeftCorner<D, D>() = impact.w;
  contact.q.setZero();
  contact.q.template head<D>() = impact.v;
  contact.mu = impact.mu;
  contact.speed_scale = impact.v.norm();
  problem.contacts.push_back(contact);
  problem.first = {0};
  if (phases) problem.couple(0, Problem::Block::Zero());  // coupled to itself by a block of zeros
  problem.first.push_back(problem.couplings());
  Rebound<D> rebound;
  rebound.form = form;
  rebound.e_n = impact.e;
  rebound.before = contact.q;
  std::vector<Row> impulse(1, Row::Zero());
  SolveSettings settings;
  settings.tolerance = 1e-13;
  ImpactSolver<D>().solve(problem, {rebound}, settings, impulse);
  return outcome_of<D>(impact, impulse[0].template head<D>());
}

template <int D>
SingleOutcome<D> follow_single(const SingleImpact<D>& impact, ImpactEnd end) {
  return outcome_of<D>(impact, impact_path(impact.w, impact.v, impact.mu, end, impact.e));
}

template SingleOutcome<2> solve_single(const SingleImpact<2>&, RestitutionForm, bool);
template SingleOutcome<3> solve_single(const SingleImpact<3>&, RestitutionForm, bool);
template SingleOutcome<2> follow_single(const SingleImpact<2>&, ImpactEnd);
template SingleOutcome<3> follow_single(const SingleImpact<3>&, ImpactEnd);

}  // namespace flyrock
