#pragma once
// The one entry to the contact solvers.

#include <optional>
#include <vector>

#include "solver/nlgs.h"
#include "solver/proximal_newton.h"

namespace flyrock {

/// Solves friction problems with the solver that the settings name. `automatic` begins with NLGS, which nearly always
/// suffices; then it takes turns with Newton steps (proximal_newton.h), and where both have stalled twice it goes on with
/// proximal points (proximal_point.h), until one of them converges or the sweeps are spent. What a turn costs is counted,
/// not timed: the same problem takes the same way on every machine.
/// It keeps its buffers: no allocation while NLGS suffices. Instantiated for D = 2, 3.
template <int D>
class Solver {
 public:
  using Row = typename ContactProblem<D>::Row;

  /// `r` holds the start (zero, or the impulses of the last step) and the answer.
  SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r);

 private:
  SolveResult take_turns(const ContactProblem<D>& problem, const SolveSettings& settings, std::vector<Row>& r);

  Nlgs<D> nlgs_;
  std::optional<ProximalNewton<D>> newton_;  ///< made when it is first needed
  std::vector<Row> best_;
};

/// The same for a single problem.
template <int D>
SolveResult solve(const ContactProblem<D>& problem, const SolveSettings& settings,
                  std::vector<typename ContactProblem<D>::Row>& r) {
  return Solver<D>().solve(problem, settings, r);
}

}  // namespace flyrock
