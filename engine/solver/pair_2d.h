#pragma once
// Exact solution of two contacts with friction in 2D, which share a body: the corners of a box on the ground.

#include <array>
#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// What one contact does.
enum class PairState { open, sticks, slides_forward, slides_backward };

/// The states in which two contacts can be, the likely one first: that of the impulses r.
std::array<std::array<PairState, 2>, 16> pair_states(const ContactProblem<2>& problem,
                                                     const std::vector<ContactProblem<2>::Row>& r);

/// Solves the linear equations of two plain contacts (ContactProblem::Contact::is_plain) in these states:
///   open            r_n = r_t = 0
///   sticks          u_n = u_t = 0
///   slides          u_n = 0,  r_t = -+ mu r_n
/// Where both stick, the body may carry any load along the line between them; the answer is the one nearest
/// to r. False, and r unchanged, where an impulse pulls or friction exceeds its bound. The velocities of the
/// answer are for the caller to judge (residual.h).
bool solve_pair(const ContactProblem<2>& problem, const std::array<PairState, 2>& states,
                std::vector<ContactProblem<2>::Row>& r);

}  // namespace flyrock
