#include "solver/proximal_newton.h"

#include <algorithm>
#include <cmath>

#include "solver/residual.h"

namespace flyrock {

namespace {

/// Exactly within bounds, where a step ends a little outside. On the way it is left there: clipped steps do not converge.
template <int D>
void clip(const ContactProblem<D>& problem, std::vector<typename ContactProblem<D>::Row>& r) {
  for (int a = 0; a < problem.size(); ++a)
    for (int g = 0; g < static_cast<int>(ContactProblem<D>::groups.size()); ++g) {
      const auto [begin, count] = ContactProblem<D>::groups[g];
      const double radius = problem.contacts[a].radius(g, r[a][0]), size = r[a].segment(begin, count).stableNorm();
      if (size > radius)
        for (int i = begin; i < begin + count; ++i) r[a][i] *= radius / size;
    }
}

}  // namespace

/// Fills states_; answers with the number of unknowns.
template <int D>
int ProximalNewton<D>::read_states(const Problem& problem, const std::vector<Row>& r) {
  states_.resize(problem.contacts.size());
  int first = 0;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    const Row u = problem.velocity(a, r), &x = r[a];
    const double w = contact.w.diagonal().template head<D>().maxCoeff();
    State& state = states_[a];
    state.first = first;
    state.unknowns = 0;
    state.start.setZero(), state.spring.setZero(), state.pull.setZero(), state.directions.setZero(), state.tests.setZero();
    const double n = contact.normal && w > 0 ? std::max(0.0, x[0] - u[0] / w) : 0;
    const double r_n = n > 0 ? std::max(0.0, x[0]) : 0;
    if (n > 0) {
      state.directions(0, 0) = state.tests(0, 0) = 1;
      state.start[0] = r_n;
      state.unknowns = 1;
    }
    for (int g = 0; g < static_cast<int>(Problem::groups.size()); ++g) {
      const auto [begin, count] = Problem::groups[g];
      const double radius = contact.radius(g, n);
      const double diagonal = g == 0 ? w : contact.w.diagonal().segment(begin, count).maxCoeff();
      if (radius <= 0 || diagonal <= 0) continue;
      double e[2] = {0, 0}, size = 0;
      for (int i = 0; i < count; ++i) e[i] = x[begin + i] - u[begin + i] / diagonal;
      size = std::hypot(e[0], e[1]);
      if (size <= radius) {  // held
        for (int i = begin; i < begin + count; ++i, ++state.unknowns) {
          state.directions(i, state.unknowns) = state.tests(i, state.unknowns) = 1;
          state.start[i] = x[i];
        }
        continue;
      }
      e[0] /= size, e[1] /= size;
      const double bound = contact.radius(g, r_n);
      for (int i = 0; i < count; ++i) {
        state.start[begin + i] = bound * e[i];
        if (n > 0) state.directions(begin + i, 0) = contact.bound(g) * e[i];
      }
      if (count == 1) continue;
      constexpr double least_share = 1e-12;
      const double across = e[0] * x[begin + 1] - e[1] * x[begin], share = std::max(bound / size, least_share);
      const int k = state.unknowns++;
      state.directions(begin, k) = state.tests(begin, k) = -e[1];
      state.directions(begin + 1, k) = state.tests(begin + 1, k) = e[0];
      state.start[begin] -= across * e[1], state.start[begin + 1] += across * e[0];
      state.spring[k] = std::max(0.0, 1 - share) / share * diagonal;
      state.pull[k] = state.spring[k] * across;
    }
    first += state.unknowns;
  }
  return first;
}

/// Replaces r by the solution of the linearised equations; false where there is none.
template <int D>
bool ProximalNewton<D>::step(const Problem& problem, double alpha, std::vector<Row>& r) {
  const int unknowns = read_states(problem, r);
  if (unknowns == 0) return false;
  for (int a = 0; a < problem.size(); ++a) r[a] = states_[a].start;
  entries_.clear();
  right_.resize(unknowns);
  const auto enter = [&](const State& row, const State& column, const Block& w) {
    const Block m = row.tests.transpose() * w * column.directions;
    for (int j = 0; j < column.unknowns; ++j)
      for (int i = 0; i < row.unknowns; ++i) entries_.emplace_back(row.first + i, column.first + j, m(i, j));
  };
  for (int a = 0; a < problem.size(); ++a) {
    const State& state = states_[a];
    if (state.unknowns == 0) continue;
    const auto& contact = problem.contacts[a];
    Block w = contact.w;
    w.diagonal() *= 1 + alpha;
    enter(state, state, w);
    for (int k = problem.first[a]; k < problem.first[a + 1]; ++k)
      if (states_[problem.other(k)].unknowns > 0) enter(state, states_[problem.other(k)], problem.full_block(k));
    const Row rest = state.tests.transpose() * problem.velocity(a, r) + state.pull;
    for (int i = 0; i < state.unknowns; ++i) {
      right_[state.first + i] = -rest[i];
      if (state.spring[i] > 0) entries_.emplace_back(state.first + i, state.first + i, state.spring[i]);
    }
  }
  matrix_.resize(unknowns, unknowns);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  factors_.compute(matrix_);
  if (factors_.info() != Eigen::Success) return false;
  z_ = factors_.solve(right_);
  if (!z_.allFinite()) return false;
  for (int a = 0; a < problem.size(); ++a) {
    const State& state = states_[a];
    for (int i = 0; i < state.unknowns; ++i) r[a] += z_[state.first + i] * state.directions.col(i);
    if (r[a][0] < 0) r[a].setZero();
  }
  return true;
}

template <int D>
SolveResult ProximalNewton<D>::solve(const Problem& problem, const SolveSettings& settings, Nlgs<D>& sweeper, int steps,
                                     std::vector<Row>& r) {
  constexpr double first_alpha = 1e-6, least_alpha = 1e-14, greatest_alpha = 100;
  constexpr int sweeps = 2;
  constexpr double tolerable = 10;  // a residual up to so many times the best is gone on from
  SolveResult best;
  judge(problem, settings, r, best);
  best_ = r;
  double alpha = first_alpha;
  int taken = 0;
  while (!best.converged && taken < steps) {
    ++taken;
    trial_ = r;
    const bool solved = step(problem, alpha, trial_);
    SolveResult found;
    judge(problem, settings, trial_, found);
    if (found.converged) {
      clip(problem, trial_);
      judge(problem, settings, trial_, found);
    }
    if (!found.converged) {
      swept_ = trial_;
      for (int k = 0; k < sweeps; ++k) sweeper.sweep_once(swept_);
      SolveResult after;
      judge(problem, settings, swept_, after);
      if (after.converged || after.residual < found.residual) trial_.swap(swept_), found = after;
    }
    if (solved && (found.converged || found.residual < best.residual)) {
      best = found;
      best_ = r = trial_;
      alpha = std::max(0.1 * alpha, least_alpha);
    } else {
      alpha = std::min(10 * alpha, greatest_alpha);
      r = found.residual < tolerable * best.residual ? trial_ : best_;
    }
  }
  r = best_;
  if (!best.converged) {
    clip(problem, r);
    judge(problem, settings, r, best);
  }
  best.iterations = taken;
  best.solver = SolverKind::proximal_newton;
  return best;
}

template class ProximalNewton<2>;
template class ProximalNewton<3>;

}  // namespace flyrock
