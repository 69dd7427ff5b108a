#pragma once
// The single entry point of the contact solvers.

#include <memory>
#include <vector>

#include "solver/islands.h"
#include "solver/nlgs.h"

namespace flyrock {

template <int D>
class ProximalNewton;

/// Solves friction problems with the solver that the settings name. `automatic` begins with NLGS, which is
/// nearly always enough. It continues with Newton steps (proximal_newton.h) if the convergence of the sweeps
/// predicts that NLGS would take longer. Costs are counted, not timed, so that the same problem is solved in
/// the same way on every machine. By the measure `step` each island is solved apart, so that bodies that do
/// not touch do not wait for each other and get the same bits as alone. The solver does not allocate while
/// NLGS is enough. Instantiated for D = 2, 3.
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
  SolveResult solve_islands(const ContactProblem<D>& problem, const SolveSettings& settings,
                            std::vector<Row>& r);
  SolveResult solve_whole(const ContactProblem<D>& problem, const SolveSettings& settings,
                          std::vector<Row>& r);
  SolveResult solve_by_kind(const ContactProblem<D>& problem, const SolveSettings& settings,
                            std::vector<Row>& r);
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
  Islands<D> islands_;
  ContactProblem<D> island_;  ///< the one that is solved now, and its impulses
  std::vector<Row> of_island_;
};

/// The same for a single problem.
template <int D>
SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings,
                  std::vector<typename ContactProblem<D>::Row>& r) {
  return Solver<D>().solve(problem, settings, r);
}

}  // namespace flyrock
