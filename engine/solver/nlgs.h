#pragma once
// Non-linear Gauss-Seidel.

#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

struct NlgsSettings {
  double tolerance = 1e-6;    ///< of each contact's speed_scale
  int max_iterations = 1000;
};

/// Sweeps over the contacts in their order, each local problem solved exactly with the others frozen. `r` holds the
/// start (zero, or the impulses of the last step) and the answer. A contact has converged when its local_error is at most
///   tolerance * speed_scale + 32 eps (|q| + sum |W_ab| |r_b|):
/// the second term is what rounding allows. Instantiated for D = 2.
template <int D>
SolveResult solve_nlgs(const ContactProblem<D>& problem, const NlgsSettings& settings,
                       std::vector<typename ContactProblem<D>::Row>& r);

}  // namespace flyrock
