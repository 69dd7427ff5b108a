#pragma once
// All complementary states of a problem of few contacts, by enumeration.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/few_contacts.h"

namespace flyrock {

/// What a contact does. `closed` is one that cannot stick: it has no friction, or its slip is given.
enum class ContactMode { open, closed, sticks, slides_forward, slides_back };

/// Why a state is no solution.
enum class StateFault {
  none,
  no_impulse,  ///< no impulses satisfy its equations
  penetrates,  ///< u_n < 0
  pulls,       ///< r_n < 0
  exceeds,     ///< |r_t| > mu r_n
  along_slip   ///< friction acts along the slip
};
constexpr int state_faults = 6;

struct ComplementaryState {
  std::vector<ContactMode> states;
  Eigen::VectorXd r, u;  ///< that satisfy its equations; empty if none do
  bool many = false;     ///< r is one of infinitely many solutions
  StateFault fault = StateFault::none;
  int contact = 0;  ///< the first one at fault
  double value =
      0;  ///< what is below 0 there: u_n, r_n, mu r_n - |r_t|, or the speed of slip against friction
};

struct StateSurvey {
  std::uint64_t count = 0;                             ///< of all states
  std::array<std::uint64_t, state_faults> by_fault{};  ///< how many end so; [none]: the feasible ones
  std::vector<ComplementaryState> states;              ///< all; if they are too many, feasible ones
  std::vector<std::vector<std::size_t>> motions;       ///< feasible ones among `states` that share u
};

/// A contact that cannot stick has 2 states, another one 4.
std::uint64_t number_of_states(const FewContacts& problem);

/// Solves the equations of each state, and tests its signs:
///   open             r = 0                          u_n >= 0
///   closed           u_n = 0,  r_t = -slip mu r_n   r_n >= 0
///   sticks           u_n = 0,  u_t = 0              r_n >= 0,  |r_t| <= mu r_n
///   slides forward   u_n = 0,  r_t = -mu r_n        r_n >= 0,  u_t >= 0
///   slides back      u_n = 0,  r_t =  mu r_n        r_n >= 0,  u_t <= 0
/// If the equations are dependent, a state is feasible if one of their solutions has the signs (nonnegative
/// least squares). A solution on the border of two states counts for both, so that solutions are told apart
/// by their velocities: `motions`. Lists `most` states at most. The time grows as the number of states.
/// Source: R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 1992, section 1.3
/// (complementary cones); V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008,
/// chapter 12.
StateSurvey survey_states(const FewContacts& problem, std::size_t most);

}  // namespace flyrock
