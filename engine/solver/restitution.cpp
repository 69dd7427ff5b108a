#include "solver/restitution.h"

#include <algorithm>
#include <cmath>

#include "solver/impact_path.h"

namespace flyrock {

namespace {

/// Whether a contact is coupled to no other.
template <class Problem>
bool is_alone(const Problem& problem, int a) {
  return problem.first[a] == problem.first[a + 1];
}

/// Whether a contact collides by a law of form `velocity`.
template <int D>
bool is_struck(const Rebound<D>& rebound) {
  return rebound.form == RestitutionForm::velocity && rebound.before[0] < 0;
}

/// Adds the impulse of a contact that is solved apart to its q, and leaves the common problem nothing to do.
template <class Contact, class Row>
void take_out(Contact& contact, const Row& impulse) {
  contact.q += contact.w * impulse;
  contact.normal = false;
  contact.mu = contact.mu_r = contact.mu_spin = 0;
  contact.bound_from(0, 0);
}

/// The impulse that gives a contact the velocity of its law of form `velocity`. Where the contact lies off
/// the centre of its body, W couples normal and tangent, and this velocity can have more energy 1/2 v W^-1 v
/// than the one before: it is then shortened, unless the law itself answers with more than 1.
template <int D>
Eigen::Matrix<double, D, 1> impulse_of_law(const typename ContactProblem<D>::Contact& contact,
                                           const Rebound<D>& rebound) {
  constexpr double rounding = 1e-12;
  using Velocity = Eigen::Matrix<double, D, 1>;
  const Eigen::Matrix<double, D, D> w = contact.w.template topLeftCorner<D, D>();
  const Velocity before = rebound.before.template head<D>();
  Velocity after = rebound.e_t * before;
  after[0] = -rebound.e_n * before[0];
  const double energy_before = before.dot(w.ldlt().solve(before)),
               energy_after = after.dot(w.ldlt().solve(after));
  const bool gains = rebound.e_n > 1 || std::abs(rebound.e_t) > 1;
  if (!gains && energy_after > (1 + rounding) * energy_before)
    after *= std::sqrt(energy_before / energy_after);
  return w.ldlt().solve(after - contact.q.template head<D>());
}

/// Gives the contacts of form `velocity` the impulses of their laws in `alone`, as if each were alone, and
/// adds these to the q of all contacts; `free` is q of compression. A contact that is coupled to others stays
/// in the common problem with e = 0, so that what the others push back does not penetrate there.
template <int D, class Rows>
void strike(ContactProblem<D>& problem, const std::vector<Rebound<D>>& rebounds, Rows& alone, Rows& free) {
  bool is_coupled = false;
  for (int a = 0; a < problem.size(); ++a) {
    if (!is_struck(rebounds[a])) continue;
    alone[a].template head<D>() = impulse_of_law<D>(problem.contacts[a], rebounds[a]);
    if (is_alone(problem, a))
      take_out(problem.contacts[a], alone[a]);
    else
      is_coupled = true;
  }
  if (!is_coupled) return;
  for (int a = 0; a < problem.size(); ++a) {
    if (is_alone(problem, a)) continue;
    problem.contacts[a].q = problem.outside_velocity(a, alone) + problem.contacts[a].w * alone[a];
    free[a] = problem.contacts[a].q;
  }
}

}  // namespace

template <int D>
bool ImpactSolver<D>::two_phase(int a, const Rebound<D>& rebound) const {
  return rebound.e_n > 0 &&
         (rebound.form == RestitutionForm::poisson || rebound.form == RestitutionForm::energy) &&
         free_[a][0] < 0;
}

/// Solves a contact of form `poisson` or `energy` that is coupled to no other along its path in impulse
/// space, and adds its impulse to q. False if the contact must be solved in the common problem.
template <int D>
bool ImpactSolver<D>::solve_alone(Problem& problem, int a, const Rebound<D>& rebound) {
  auto& contact = problem.contacts[a];
  if (!is_alone(problem, a) || !two_phase(a, rebound) || contact.c_t != 0 || contact.resists_rotation())
    return false;
  const ImpactEnd end = rebound.form == RestitutionForm::poisson ? ImpactEnd::poisson : ImpactEnd::energy;
  const Eigen::Matrix<double, D, D> w = contact.w.template topLeftCorner<D, D>();
  const Eigen::Matrix<double, D, 1> v = contact.q.template head<D>();
  alone_[a].template head<D>() = impact_path(w, v, contact.mu, end, rebound.e_n);
  take_out(contact, alone_[a]);
  return true;
}

/// q + W given.
template <int D>
void ImpactSolver<D>::add_given(Problem& problem) const {
  for (int a = 0; a < problem.size(); ++a) {
    auto& contact = problem.contacts[a];
    contact.q = problem.outside_velocity(a, given_) + contact.w.col(0) * given_[a][0];
  }
}

template <int D>
SolveResult ImpactSolver<D>::solve(Problem& problem, const std::vector<Rebound<D>>& rebounds,
                                   const SolveSettings& settings, std::vector<Row>& r) {
  const int n = problem.size();
  free_.resize(n), given_.resize(n);
  alone_.assign(n, Row::Zero());
  factor_.assign(n, -1);
  bool given = false, phases = false;
  if (trace) trace->mu.clear();
  for (int a = 0; a < n; ++a) {
    if (trace) trace->mu.push_back(problem.contacts[a].mu);
    given_[a].setZero();
    given_[a][0] = rebounds[a].given;
    given = given || rebounds[a].given != 0;
    r[a][0] = std::max(0.0, r[a][0] - rebounds[a].given);
  }
  if (given) add_given(problem);
  for (int a = 0; a < n; ++a) free_[a] = problem.contacts[a].q;
  if (trace) trace->free = free_;
  strike(problem, rebounds, alone_, free_);
  for (int a = 0; a < n; ++a) {
    auto& contact = problem.contacts[a];
    const Rebound<D>& rebound = rebounds[a];
    if (is_struck(rebound) || solve_alone(problem, a, rebound)) {
      r[a].setZero();
    } else if (two_phase(a, rebound)) {
      factor_[a] = rebound.e_n;
      phases = true;
    } else if (rebound.form == RestitutionForm::newton) {
      contact.q[0] += rebound.e_n * rebound.shift();
      contact.q.template segment<D - 1>(1) += rebound.e_t * rebound.before.template segment<D - 1>(1);
    } else if (rebound.form == RestitutionForm::newton_mean) {
      contact.q[0] += rebound.e_n * rebound.shift();
      contact.q.template tail<Problem::rows - 1>() += rebound.before.template tail<Problem::rows - 1>();
    }
  }

  if (trace) {
    trace->alone = alone_;
    trace->common = {problem, r, {}};
    trace->restitution.reset();
  }
  SolveResult result = solver_.solve(problem, settings, r);
  if (trace) trace->common.r = r;
  if (phases) {
    turn_.resize(n), expansion_.resize(n);
    for (int a = 0; a < n; ++a) turn_[a] = problem.outside_velocity(a, r) + problem.contacts[a].w * r[a];
    constexpr int most_adjustments = 100;
    constexpr double balanced = 1e-10;
    double imbalance = 0;
    for (int k = 0; k < most_adjustments; ++k) {
      const SolveResult expansion = expand(problem, settings, r);
      result.converged = result.converged && expansion.converged;
      result.iterations += expansion.iterations;
      result.work += expansion.work;
      if (expansion.residual > result.residual || !expansion.converged)
        result.residual = expansion.residual, result.worst_contact = expansion.worst_contact;
      imbalance = adjust_factors(problem, rebounds, r);
      if (imbalance <= balanced) break;
    }
    result.converged = result.converged && imbalance <= balanced;
    for (int a = 0; a < n; ++a) r[a] += expansion_[a];
  }
  for (int a = 0; a < n; ++a) {
    r[a] += alone_[a];
    r[a][0] += rebounds[a].given;
  }
  return result;
}

/// The second phase: impulses L + r with the given L = f r_Cn. The sum bounds friction, rolling and spinning.
template <int D>
SolveResult ImpactSolver<D>::expand(Problem& problem, const SolveSettings& settings,
                                    const std::vector<Row>& compression) {
  for (int a = 0; a < problem.size(); ++a) {
    auto& contact = problem.contacts[a];
    given_[a].setZero();
    if (factor_[a] > 0) given_[a][0] = factor_[a] * compression[a][0];
    contact.q = turn_[a];
    contact.bound_from(given_[a][0], 0);
    expansion_[a].setZero();
  }
  add_given(problem);
  if (trace) trace->restitution = {problem, expansion_, {}};
  const SolveResult result = solver_.solve(problem, settings, expansion_);
  if (trace) trace->restitution->r = expansion_;
  for (int a = 0; a < problem.size(); ++a) expansion_[a] += given_[a];
  return result;
}

/// Moves f of the contacts of form energy towards their energy balance. Returns the largest relative error of
/// that balance.
template <int D>
double ImpactSolver<D>::adjust_factors(const Problem& problem, const std::vector<Rebound<D>>& rebounds,
                                       const std::vector<Row>& compression) {
  double worst = 0;
  for (int a = 0; a < problem.size(); ++a) {
    if (factor_[a] <= 0 || rebounds[a].form != RestitutionForm::energy || compression[a][0] <= 0) continue;
    const auto& contact = problem.contacts[a];
    const double change =
        (problem.outside_velocity(a, expansion_) - contact.q + contact.w * expansion_[a])[0];
    const double lost = -0.5 * compression[a][0] * (free_[a][0] + turn_[a][0]);
    const double released = 0.5 * expansion_[a][0] * (2 * turn_[a][0] + change);
    const double allowed = rebounds[a].e_n * rebounds[a].e_n * lost;
    if (allowed <= 0) continue;
    // If other contacts press harder than f requires, the contact does not open and its work is below the
    // allowed one.
    const bool pressed = expansion_[a][0] > given_[a][0] * (1 + 1e-9);
    if (pressed && released <= allowed) continue;
    worst = std::max(worst, std::abs(released / allowed - 1));
    factor_[a] *= std::clamp(std::sqrt(allowed / std::max(released, 0.01 * allowed)), 0.5, 2.0);
  }
  return worst;
}

template class ImpactSolver<2>;
template class ImpactSolver<3>;

}  // namespace flyrock
