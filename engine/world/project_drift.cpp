// Closes the gaps that a step leaves at its contacts.

#include <algorithm>

#include "world/world.h"

namespace flyrock {

/// Persistent contacts keep their gap only to second order in h. This stage closes the remaining gap by
/// displacements M^-1 H_n lambda, with M^-1 of linked bodies (links.h); the spin turns with its body, so that
/// this gives no energy. A contact without impulse is only pushed out of penetration, never pulled closed.
/// Where the gaps cannot all be closed, as of a sphere over several facets of a pit, the last passes only
/// push, so that no contact is closed at the cost of another. The deep penetrations of fixed time steps
/// (`exact` false) are kept, as in LMGC90; so are those of the nodes of deformable blocks.
template <int D>
void World<D>::project_drift(bool exact) {
  if (contacts_.empty()) return;
  const int closing = contacts_.size() == 1 ? 1 : 3;  // passes; the first one closes a single contact
  constexpr int most_pushes = 20;
  // Shares of the size. A step pushes a body out by no more than `deepest`, because more would throw it; a
  // penetration less deep than `left` waits for the next step.
  constexpr double deepest = 1e-3, left = 1e-6;
  constexpr double doubtful = 5e-4;  // deeper: the features may have slid off each other, and nothing is deep
  drift_.assign(bodies.size(), Body<D>::Rows::Zero());
  push_.assign(links.empty() ? 0 : bodies.size(), Body<D>::Rows::Zero());
  swell_.assign(bodies.size(), 0.0);
  gaps_.clear();
  sunk_ = sunk_share_ = 0;
  for (const Contact& c : contacts_) {
    const double gap = gap_at(c, false), size = contact_size(c.candidate, c.antagonist);
    const double reach = carry_reach(c.candidate, c.antagonist);
    const double most = exact ? std::max(reach, deepest * size) : reach;
    const bool slid_off = exact && gap < -doubtful * size && !is_deep(c, gap, false);
    const bool near = gap <= reach && (exact || gap >= -most) && !slid_off;
    if (!slid_off) {
      sunk_ = std::max(sunk_, -gap);
      sunk_share_ = std::max(sunk_share_, -gap / size);
    }
    const bool yields = c.law.condition == NormalCondition::penalty || deforms(c);
    gaps_.push_back(near && !yields ? std::optional(std::max(gap, -most)) : std::nullopt);
  }
  const auto gap_of = [&](std::size_t a) {
    const Contact& c = contacts_[a];
    double gap = *gaps_[a];
    for_bodies(a, [&](int i, const auto& columns) { gap += columns.col(0).dot(drift_[i]); });
    for (const int i : {c.candidate, c.antagonist})
      if (i >= 0 && bodies[i].breathes()) gap += bodies[i].breathing.side * swell_[i];
    return gap;
  };
  const auto close = [&](std::size_t a, double gap) {
    const double lambda = -gap / problem_.contacts[a].w(0, 0);
    auto& moved = links.empty() ? drift_ : push_;
    for_bodies(a, [&](int i, const auto& columns) {
      moved[i] += bodies[i].inverse_mass_times(lambda * columns.col(0));
      if (bodies[i].breathes())
        swell_[i] += bodies[i].breathing.inverse_mass(theta_h_) * bodies[i].breathing.side * lambda;
    });
    if (links.empty()) return;
    links.hold(bodies, push_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      drift_[i] += push_[i];
      push_[i].setZero();
    }
  };
  for (int pass = 0; pass < closing; ++pass)
    for (std::size_t a = 0; a < contacts_.size(); ++a)
      if (gaps_[a])
        if (const double gap = gap_of(a); contacts_[a].impulse[0] > 0 || gap < 0) close(a, gap);
  bool pushed = exact;
  for (int pass = 0; pass < most_pushes && pushed; ++pass) {
    pushed = false;
    for (std::size_t a = 0; a < contacts_.size(); ++a) {
      if (!gaps_[a]) continue;
      const double gap = gap_of(a);
      if (gap >= -left * contact_size(contacts_[a].candidate, contacts_[a].antagonist)) continue;
      close(a, gap);
      pushed = true;
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) {
      bodies[i].displace(drift_[i]);
      if constexpr (D == 3) bodies[i].w = Rotation3::from_vector(Space<3>::spin_of(drift_[i])) * bodies[i].w;
      if (bodies[i].breathes()) bodies[i].swell(swell_[i]);
    }
}

template void World<2>::project_drift(bool);
template void World<3>::project_drift(bool);

}  // namespace flyrock
