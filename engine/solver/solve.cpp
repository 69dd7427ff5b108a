#include "solver/solve.h"

#include "solver/proximal_point.h"

namespace flyrock {

template <int D>
SolveResult Solver<D>::solve(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r) {
  if (settings.solver == SolverKind::automatic) return take_turns(problem, settings, r);
  if (settings.solver == SolverKind::nlgs) return nlgs_.solve(problem, settings, r);
  constexpr int first_sweeps = 20;
  nlgs_.begin(problem, settings, r);
  for (int k = 0; k < first_sweeps; ++k) nlgs_.sweep_once(r);
  return newton_.emplace().solve(problem, settings, nlgs_, settings.max_iterations, r);
}

template <int D>
SolveResult Solver<D>::take_turns(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r) {
  constexpr int first_turn = 128;  // sweeps
  constexpr int first_steps = 10;
  constexpr int sweeps_of_a_step = 20;
  constexpr int most_steps = 20;   // of a turn; then they have stalled twice
  nlgs_.begin(problem, settings, r);
  SolveResult result = nlgs_.run(first_turn, r);
  for (int steps = first_steps; !result.converged && result.iterations < settings.max_iterations; steps *= 2) {
    if (steps > most_steps) {
      const int used = result.iterations;
      result = solve_proximal_point(problem, settings, settings.max_iterations - used, r);
      result.iterations += used;
      return result;
    }
    if (!newton_) newton_.emplace();
    best_ = r;
    const SolveResult newton = newton_->solve(problem, settings, nlgs_, steps, best_);
    if (newton.converged || newton.residual < result.residual) r = best_;
    if (newton.converged) return newton;
    result = nlgs_.run(2 * steps * sweeps_of_a_step, r);
  }
  return result;
}

template class Solver<2>;
template class Solver<3>;

}  // namespace flyrock
