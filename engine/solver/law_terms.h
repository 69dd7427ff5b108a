#pragma once
// A law as terms of the friction problem.

#include <algorithm>

#include "plugin/contact_law.h"
#include "solver/restitution.h"

namespace flyrock {

/// Puts the law of a contact into its row of the problem, for a step of length h (0: an impact), and into
/// `rebound`, whose v^- is left alone. `gap`: where the contact is detected; `sticking`: in the last step. A
/// pull c_n that the contact bears and the push of a spring are given impulses L, -h c_n and h k max(0,
/// -gap). Friction, rolling and spinning are bounded by all that presses: |r_t| <= mu r_n + h c_t, and |m_r|
/// <= mu_r r_n or, where the contact bears a pull, mu_r (r_n + h c_n).
template <int D>
void set_law(const ContactLaw& law, bool sticking, double gap, double h,
             typename ContactProblem<D>::Contact& contact, Rebound<D>& rebound) {
  const bool spring = law.condition == NormalCondition::penalty;
  contact.mu = sticking ? law.mu_s : law.mu_d;
  contact.mu_r = law.mu_r;
  contact.mu_spin = law.mu_spin;
  contact.normal = !spring;
  rebound.form = law.form;
  rebound.e_n = law.e_n;
  rebound.e_t = law.e_t;
  rebound.as_lmgc90 = law.as_lmgc90;
  rebound.given = spring ? h * law.stiffness * std::max(0.0, -gap) : -h * law.c_n;
  contact.bound_from(rebound.given, h * law.c_t);
  if (law.condition == NormalCondition::quasi_shock && h > 0) contact.q[0] += std::max(0.0, gap) / h;
}

}  // namespace flyrock
