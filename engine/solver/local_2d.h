#pragma once
// One contact of the plane, the others frozen: solved exactly.

#include "solver/contact_problem.h"

namespace flyrock {

/// The impulse r of one contact with u = b + W r, by enumeration of its states in this order: no contact; stick or slide
/// (with rolling resistance: each with the rolling row stuck, rolling forward or backward). Each state is a linear
/// system; the first whose signs hold is the answer. W symmetric positive definite guarantees that there is one; where
/// rounding leaves none, the state that violates its signs least is taken.
ContactProblem<2>::Row solve_local(const ContactProblem<2>::Contact& contact, const ContactProblem<2>::Row& b);

/// The scaled local map of a contact in m/s: with rho = 1 / max(W_nn, W_tt),
///   e_n = (r_n - max(0, r_n - rho u_n)) / rho,  e_t = (r_t - clamp(r_t - rho u_t, mu r_n + c_t)) / rho,
/// and the rolling row likewise with its own diagonal, brought to m/s by the length sqrt(W_nn / W_rr). The greatest.
/// Zero exactly at a solution.
double local_error(const ContactProblem<2>::Contact& contact, const ContactProblem<2>::Row& u,
                   const ContactProblem<2>::Row& r);

}  // namespace flyrock
