#pragma once
// The last resort: a sequence of problems that NLGS solves easily.

#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

/// From a centre c, the problem with W + alpha diag(W) in place of W_aa and q - alpha diag(W) c in place of q; its solution is
/// the next centre. A fixed point solves the problem itself, the shifted one is regular and NLGS solves it in a few dozen
/// sweeps; the sequence of centres is accelerated (anderson.h). Slow, but it goes on where Newton steps and sweeps stall:
/// at packings so hyperstatic and so full of contacts on the edge of sliding that no state of them stands still.
/// `sweeps` bounds the sweeps of all the shifted problems. r holds the start and the best that was judged; the result's
/// iterations are sweeps. It allocates. Instantiated for D = 2, 3.
template <int D>
SolveResult solve_proximal_point(const ContactProblem<D>& problem, const SolveSettings& settings, int sweeps,
                                 std::vector<typename ContactProblem<D>::Row>& r);

}  // namespace flyrock
