#pragma once
// The impact of a point: one contact of a mass without extent.

#include <algorithm>
#include <cmath>

#include "plugin/contact_law.h"

namespace flyrock {

/// The velocity [m/s] after the impact of a point that arrives with v = (v_n, v_t[, v_s]), v_n < 0. Its W is
/// the unit matrix divided by its mass, so that normal and tangential velocities are not coupled and the mass
/// cancels. All forms of restitution (solver/restitution.h) then have the normal velocity -e_n v_n, because
/// Newton, Poisson and Stronge agree. With friction p_t <= mu p_n the tangential velocity keeps its direction
/// and loses at most mu (1 + e_n) |v_n|:
///   newton, poisson, energy: until it is -e_t v_t (e_t belongs to newton only)
///   newton_mean: until it is -v_t
///   velocity: it is e_t v_t, whatever the friction.
template <int D>
Vec<D> rebound_of_point(const Vec<D>& v, const Restitution& law, double mu) {
  Vec<D> after = v;
  after[0] = -law.e_n * v[0];
  const double slip = D == 2 ? std::abs(v[1]) : v.template tail<D - 1>().norm();
  if (law.form == RestitutionForm::velocity) {
    after.template tail<D - 1>() *= law.e_t;
  } else if (slip > 0) {
    const double e_t = law.form == RestitutionForm::newton_mean ? 1 : law.e_t;
    const double lost = std::min((1 + e_t) * slip, -mu * (1 + law.e_n) * v[0]);
    after.template tail<D - 1>() *= (slip - lost) / slip;
  }
  return after;
}

}  // namespace flyrock
