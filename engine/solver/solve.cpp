#include "solver/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/local_2d.h"
#include "solver/pair_2d.h"
#include "solver/proximal_newton.h"
#include "solver/residual.h"

namespace flyrock {

namespace {

/// The cost of a Newton step, in sweeps: measured as 2 for few contacts; a factorisation of many costs more.
template <int D>
int sweeps_of_a_step(const ContactProblem<D>& problem) {
  return problem.size() <= few_contacts ? 2 : 10;
}

/// The residual divided by the wanted residual.
template <int D>
double excess(const ContactProblem<D>& problem, const SolveSettings& settings, const SolveResult& result) {
  const double scale =
      settings.measure == ErrorMeasure::merit ? 1 : problem.contacts[result.worst_contact].speed_scale;
  return result.residual / (settings.tolerance * scale);
}

}  // namespace

template <int D>
Solver<D>::Solver() = default;
template <int D>
Solver<D>::Solver(Solver&&) noexcept = default;
template <int D>
Solver<D>& Solver<D>::operator=(Solver&&) noexcept = default;
template <int D>
Solver<D>::~Solver() = default;

template <int D>
SolveResult Solver<D>::solve(const ContactProblem<D>& problem, const SolveSettings& settings,
                             std::vector<Row>& r) {
  // The merit is one number of the whole problem.
  if (settings.measure == ErrorMeasure::step && problem.size() > 1) {
    islands_.find(problem);
    if (islands_.count() > 1) return solve_islands(problem, settings, r);
  }
  return solve_whole(problem, settings, r);
}

template <int D>
SolveResult Solver<D>::solve_islands(const ContactProblem<D>& problem, const SolveSettings& settings,
                                     std::vector<Row>& r) {
  SolveResult all;
  all.converged = true;
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> contacts = islands_.contacts(i);
    islands_.extract(problem, i, island_);
    of_island_.clear();
    for (const int a : contacts) of_island_.push_back(r[a]);
    const SolveResult found = solve_whole(island_, settings, of_island_);
    for (std::size_t k = 0; k < contacts.size(); ++k) r[contacts[k]] = of_island_[k];
    // An island that failed counts as worse than any that did not.
    const bool is_worse = found.converged == all.converged ? found.residual > all.residual : !found.converged;
    if (i == 0 || is_worse) all.residual = found.residual, all.worst_contact = contacts[found.worst_contact];
    all.converged = all.converged && found.converged;
    all.iterations = std::max(all.iterations, found.iterations);
    all.work += found.work;
    if (found.solver == SolverKind::proximal_newton) all.solver = found.solver;
  }
  return all;
}

template <int D>
SolveResult Solver<D>::solve_whole(const ContactProblem<D>& problem, const SolveSettings& settings,
                                   std::vector<Row>& r) {
  constexpr std::uint64_t of_sweep = 2, of_factorisation = 30;  // for each contact
  SolveResult result = solve_by_kind(problem, settings, r);
  result.work = static_cast<std::uint64_t>(result.iterations) * problem.contacts.size() *
                (result.solver == SolverKind::proximal_newton ? of_factorisation : of_sweep);
  return result;
}

template <int D>
SolveResult Solver<D>::solve_by_kind(const ContactProblem<D>& problem, const SolveSettings& settings,
                                     std::vector<Row>& r) {
  if (settings.to_rounding && problem.size() <= few_contacts) {
    const SolveResult result = refine(problem, settings, r);
    if (result.converged) return result;
  }
  switch (settings.solver) {
    case SolverKind::nlgs:
      return nlgs_.solve(problem, settings, r);
    case SolverKind::proximal_newton:
      return solve_by_newton(problem, settings, r);
    case SolverKind::automatic:
      break;
  }
  return solve_by_both(problem, settings, r);
}

/// Solves a pair by its states. r is kept if none of these leads to rounding.
template <int D>
bool Solver<D>::solve_by_states(const ContactProblem<D>& problem, const SolveSettings& finest,
                                std::vector<Row>& r, SolveResult& result) {
  if constexpr (D == 2) {
    start_ = r;
    SolveResult found = result;
    for (const auto& states : pair_states(problem, start_)) {
      if (!solve_pair(problem, states, r)) continue;
      judge(problem, finest, r, found);
      ++found.iterations;
      if (found.converged) {
        result = found;
        return true;
      }
      r = start_;
    }
  }
  return false;
}

/// Sweeps until only rounding is left: plain sweeps first, then accelerated ones as long as they help. In 2D,
/// one contact is solved in closed form, and two exactly if a few sweeps do not suffice. Convergence is
/// finally checked against the tolerance.
template <int D>
SolveResult Solver<D>::refine(const ContactProblem<D>& problem, const SolveSettings& settings,
                              std::vector<Row>& r) {
  constexpr int few = 4, plain = 16, turn = 32;  // sweeps
  constexpr double least_gain = 0.5;             // another turn follows if the last one halved the residual
  SolveSettings finest = settings;
  finest.tolerance = std::numeric_limits<double>::epsilon();
  bool by_states = false;
  SolveResult result;
  if constexpr (D == 2) {
    by_states = settings.solver == SolverKind::automatic && is_pair(problem);
    if (problem.size() == 1) {
      r[0] = solve_local(problem.contacts[0], problem.contacts[0].q);
      judge(problem, finest, r, result);
      result.iterations = 1;
      if (result.converged) return result;
    }
  }
  nlgs_.begin(problem, finest, r);
  result = nlgs_.run(by_states ? few : plain, r);
  if (result.converged || problem.size() == 0) return result;
  if (by_states && solve_by_states(problem, finest, r, result)) return result;
  nlgs_.begin_accelerated(problem, finest, r);
  for (double before = std::numeric_limits<double>::infinity(); result.residual <= least_gain * before;) {
    before = result.residual;
    result = nlgs_.run(turn, r);
    if (result.converged) break;
    if (result.iterations >= settings.max_iterations) break;
  }
  result.iterations += by_states ? few : plain;
  if (!result.converged) judge(problem, settings, r, result);
  return result;
}

template <int D>
SolveResult Solver<D>::solve_by_newton(const ContactProblem<D>& problem, const SolveSettings& settings,
                                       std::vector<Row>& r) {
  constexpr int first_sweeps = 20;
  nlgs_.begin(problem, settings, r);
  for (int k = 0; k < first_sweeps; ++k) nlgs_.sweep_once(r);
  if (!newton_) newton_ = std::make_unique<ProximalNewton<D>>();
  return newton_->solve(problem, settings, nlgs_, settings.max_iterations, r);
}

template <int D>
SolveResult Solver<D>::solve_by_both(const ContactProblem<D>& problem, const SolveSettings& settings,
                                     std::vector<Row>& r) {
  constexpr int first_turn = 32, turn = 64;  // sweeps
  constexpr int longest_way = 300;           // sweeps; beyond this Newton steps are faster
  nlgs_.begin(problem, settings, r);
  SolveResult result = nlgs_.run(first_turn, r);
  for (bool shorter = true; shorter && !result.converged && result.iterations < settings.max_iterations;) {
    const double before = excess(problem, settings, result);
    const int begin = result.iterations;
    result = nlgs_.run(begin == first_turn ? turn - first_turn : turn, r);
    const double after = excess(problem, settings, result);
    // Remaining sweeps at the rate of the last turn: log(after) / (log(before / after) / length).
    shorter = std::log(after) * (result.iterations - begin) <= longest_way * std::log(before / after);
  }
  if (result.converged || result.iterations >= settings.max_iterations) return result;
  if (!newton_) newton_ = std::make_unique<ProximalNewton<D>>();
  const int price = sweeps_of_a_step(problem);
  const int steps = (settings.max_iterations - result.iterations + price - 1) / price;
  return newton_->solve(problem, settings, nlgs_, steps, r);
}

template class Solver<2>;
template class Solver<3>;

}  // namespace flyrock
