#pragma once
// Translates a contact law into terms of the friction problem.

#include <algorithm>

#include "plugin/contact_law.h"
#include "solver/restitution.h"

namespace flyrock {

/// Writes the law of a contact into its row of the problem, for a step of length h [s] (0: an impact), and
/// into `rebound`, except its v^-. `gap` [m] is the gap at which the contact was detected. `sticking` is the
/// state in the last step. A pull c_n that the contact bears is a given impulse L = -h c_n. The total normal
/// impulse bounds friction, rolling and spinning:
///   |r_t| <= mu r_n + h c_t,   |m_r| <= mu_r r_n, or mu_r (r_n + h c_n) if the contact bears a pull.
/// For a spring (`penalty`) it writes the coefficients and h c_t; set_spring (spring.h) writes the rest.
template <int D>
void set_law(const ContactLaw& law, bool sticking, double gap, double h,
             typename ContactProblem<D>::Contact& contact, Rebound<D>& rebound) {
  const bool spring = law.condition == NormalCondition::penalty;
  contact.mu = sticking ? law.mu_s : law.mu_d;
  contact.mu_r = law.mu_r;
  contact.mu_spin = D == 3 ? law.mu_spin : 0;
  static_cast<Restitution&>(rebound) = law;
  rebound.given = spring ? 0 : -h * law.c_n;
  contact.bound_from(rebound.given, h * law.c_t);
  if (law.condition == NormalCondition::quasi_shock && h > 0) contact.q[0] += std::max(0.0, gap) / h;
}

}  // namespace flyrock
