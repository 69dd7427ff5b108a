#pragma once
// One contact of the plane, the others frozen: solved exactly.

#include "solver/contact_problem.h"

namespace flyrock {

/// The impulse r of one contact with u = b + W r, by enumeration of its states in this order: no contact;
/// stick or slide (with rolling resistance: each with the rolling row stuck, rolling forward or backward).
/// Each state is a linear system; the first whose signs hold is the answer. W symmetric positive definite
/// guarantees that there is one; where rounding leaves none, the state that violates its signs least is
/// taken.
ContactProblem<2>::Row solve_local(const ContactProblem<2>::Contact& contact,
                                   const ContactProblem<2>::Row& b);

}  // namespace flyrock
