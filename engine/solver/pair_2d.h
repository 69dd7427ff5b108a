#pragma once
// Exact solution of two contacts with friction in 2D, which share a body: the corners of a box on the ground.

#include <array>
#include <boost/container/static_vector.hpp>
#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// What one contact does. The rows of a closed contact rest (0), or move in positive (1) or negative (-1)
/// direction.
struct PairState {
  bool closed = false;
  int slides = 0, rolls = 0;
};
using PairStates = std::array<PairState, 2>;

/// Whether solve_pair serves: two contacts with a coupling, without constant parts of their bounds.
bool is_pair(const ContactProblem<2>& problem);

/// The states in which two contacts can be, the likely ones first: that of the impulses r, then those that
/// differ from it in few rows.
boost::container::static_vector<PairStates, 100> pair_states(const ContactProblem<2>& problem,
                                                             const std::vector<ContactProblem<2>::Row>& r);

/// Solves the linear equations of a pair in these states:
///   open            r_n = r_t = r_r = 0
///   closed          u_n = 0
///   a row rests     u_t = 0,              u_r = 0
///   a row moves     r_t = -+ mu r_n,      r_r = -+ mu_r r_n
/// Where more rows rest than a body has freedoms, it may carry any load between them; the answer is the one
/// nearest to r. False, and r unchanged, where an impulse pulls or a row exceeds its bound. The velocities of
/// the answer are for the caller to judge (residual.h).
bool solve_pair(const ContactProblem<2>& problem, const PairStates& states,
                std::vector<ContactProblem<2>::Row>& r);

}  // namespace flyrock
