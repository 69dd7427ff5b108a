#pragma once
// The one entry to the contact solvers.

#include <memory>
#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

template <int D>
class ProximalNewton;

/// Solves friction problems with the solver that the settings name. `automatic` begins with NLGS, which
/// nearly always suffices, and goes on with Newton steps (proximal_newton.h) where the sweeps foretell that
/// they are the longer way. What a step costs is counted, not timed: the same problem takes the same way on
/// every machine. It keeps its buffers: no allocation while NLGS suffices. Instantiated for D = 2, 3.
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
  SolveResult refine(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r);
  SolveResult solve_by_newton(const ContactProblem<D>& problem, const SolveSettings& settings,
                              std::vector<Row>& r);
  SolveResult solve_by_both(const ContactProblem<D>& problem, const SolveSettings& settings,
                            std::vector<Row>& r);

  Nlgs<D> nlgs_;
  std::unique_ptr<ProximalNewton<D>> newton_;  ///< made when it is first needed
};

/// The same for a single problem.
template <int D>
SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings,
                  std::vector<typename ContactProblem<D>::Row>& r) {
  return Solver<D>().solve(problem, settings, r);
}

}  // namespace flyrock
