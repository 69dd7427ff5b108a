#pragma once
// The single entry point of the contact solvers.

#include <memory>
#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

template <int D>
class ProximalNewton;

/// Solves friction problems with the solver that the settings name. `automatic` begins with NLGS, which is
/// nearly always enough. It continues with Newton steps (proximal_newton.h) if the convergence of the sweeps
/// predicts that NLGS would take longer. Costs are counted, not timed, so that the same problem is solved in
/// the same way on every machine. The solver does not allocate while NLGS is enough. Instantiated for D = 2,
/// 3.
template <int D>
class Solver {
 public:
  using Row = typename ContactProblem<D>::Row;

  Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  /// `r` holds the start (zero, or the impulses of the last step) and the answer.
  SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r);

 private:
  bool solve_by_states(const ContactProblem<D>& problem, const SolveSettings& finest, std::vector<Row>& r,
                       SolveResult& result);
  SolveResult refine(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r);
  SolveResult solve_by_newton(const ContactProblem<D>& problem, const SolveSettings& settings,
                              std::vector<Row>& r);
  SolveResult solve_by_both(const ContactProblem<D>& problem, const SolveSettings& settings,
                            std::vector<Row>& r);

  Nlgs<D> nlgs_;
  std::unique_ptr<ProximalNewton<D>> newton_;  ///< created when first needed
  std::vector<Row> start_;
};

/// The same for a single problem.
template <int D>
SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings,
                  std::vector<typename ContactProblem<D>::Row>& r) {
  return Solver<D>().solve(problem, settings, r);
}

}  // namespace flyrock
