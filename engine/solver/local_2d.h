#pragma once
// Exact solution of one contact in 2D, with the impulses of all others fixed.

#include "solver/contact_problem.h"

namespace flyrock {

/// The impulse r of one contact with u = b + W r, by enumeration of its states in this order: no contact;
/// stick or slip (with rolling resistance, each combined with a sticking rolling row, rolling forward or
/// rolling backward). Each state is a linear system. The answer is the first state whose signs hold. There is
/// one if W is symmetric positive definite. If rounding leaves none, the answer is the state that violates
/// its signs least.
ContactProblem<2>::Row solve_local(const ContactProblem<2>::Contact& contact,
                                   const ContactProblem<2>::Row& b);

}  // namespace flyrock
