#pragma once
// Non-linear Gauss-Seidel.

#include <limits>
#include <vector>

#include "solver/contact_problem.h"
#include "solver/local_3d.h"
#include "solver/solve_settings.h"

namespace flyrock {

/// Sweeps over the contacts in their order, each local problem solved exactly with the others frozen (local_2d.h,
/// local_3d.h). It keeps its buffers: a solve does not allocate once they have grown. Instantiated for D = 2, 3.
template <int D>
class Nlgs {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// `r` holds the start (zero, or the impulses of the last step) and the answer. The solve ends when judge (residual.h)
  /// says so, or after settings.max_iterations sweeps. Judging costs as much as a sweep: in problems of more than a few
  /// contacts it is done when the errors met on the way foretell success.
  /// With `worth` finite, the solve also ends where it will hardly finish within that many more sweeps, judged by the
  /// fall of the errors met, once a quarter as many have been spent.
  SolveResult solve(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r,
                    double worth = std::numeric_limits<double>::infinity());

 private:
  void prepare(const Problem& problem);
  template <int N>
  double sweep(const Problem& problem, ErrorMeasure measure, std::vector<Row>& r) const;

  std::vector<FrictionContact3> friction_;  ///< of each contact, in space
  std::vector<double> errors_;              ///< met by each sweep
};

template <int D>
SolveResult solve_nlgs(const ContactProblem<D>& problem, const SolveSettings& settings,
                       std::vector<typename ContactProblem<D>::Row>& r) {
  return Nlgs<D>().solve(problem, settings, r);
}

}  // namespace flyrock
