// The impacts of one instant: which of the closed contacts bear impulses, and what follows.

#include <algorithm>

#include "world/world.h"

namespace flyrock {

template <int D>
typename World<D>::Outcome World<D>::impact() {
  // A cut step ends at the touch only up to second order in its length, so accept a small gap as closed.
  constexpr double event_share = 1e-7;
  impacts_.clear();
  gained_.clear();
  last_solve_ = {};
  pressed_.clear();
  forget_steps();
  pull_links();
  detect(0);
  keep_closed(event_share);
  drifts_.clear();
  const bool endless = settings_.one_by_one && !collide_one_by_one();
  const bool approaching = settings_.one_by_one ? solve_impact() : collide_together();
  Outcome outcome = keep(0, false);
  outcome.endless = endless;
  outcome.new_touch = approaching;
  for (Contact& c : last_) c.impulse.setZero();  // impulses of an impact are no warm start for the next step
  return outcome;
}

template <int D>
void World<D>::pull_links() {
  if (links.empty()) return;
  links.begin_instant(bodies);
  links.hold(bodies);
  links.keeps_instant(bodies);
}

/// Lets the contacts collide at once; `plastic`: with e = 0. False if none approaches, so that nothing is
/// solved.
template <int D>
bool World<D>::solve_impact(bool plastic) {
  measure_before(0);
  begin_manifolds();
  ask_laws(0);
  set_rest_at_impact(plastic);
  if (!links.empty()) links.begin_instant(bodies);
  assemble(0, 0);
  const bool approaching =
      std::any_of(contacts_.begin(), contacts_.end(), [](const Contact& c) { return c.before[0] < 0; });
  if (approaching) {
    solve_instant();
    ++quality_.impact_problems;
  } else {
    for (Contact& c : contacts_) c.impulse.setZero();  // of the last step
  }
  measure_after(0);
  record_impacts();
  audit_energy(0);
  if (approaching && on_hit) on_hit();
  return approaching;
}

/// Sets how the contacts of an impact that do not collide take part: with e = 0, and by the mean slip where
/// all that collide with them have the form `newton_mean`, which else gained energy by their friction. A
/// contact that opens by the error of the step that held it may close as fast, so that it gains nothing.
template <int D>
void World<D>::set_rest_at_impact(bool plastic) {
  if (plastic) {
    for (Contact& c : contacts_) static_cast<Restitution&>(c.law) = {};
    return;
  }
  if (contacts_.size() == 1) return;
  const auto is_on_mean = [](const Contact& c) { return c.law.form == RestitutionForm::newton_mean; };
  if (std::any_of(contacts_.begin(), contacts_.end(), is_on_mean)) {
    join(contacts_);
    islands_at_instant_.assign(bodies.size(), {});
    for (const Contact& c : contacts_)
      if (c.manifold >= 0 && !is_on_mean(c)) islands_at_instant_[island_of(c)].has_other_form = true;
    for (Contact& c : contacts_)
      if (c.manifold < 0 && !islands_at_instant_[island_of(c)].has_other_form)
        c.law.form = RestitutionForm::newton_mean;
  }
  for (std::size_t a = 0; a < drifts_.size(); ++a) {
    Contact& c = contacts_[a];
    if (!drifts_[a] || c.manifold >= 0) continue;
    c.law.e_n = 1;
    c.law.as_lmgc90 = true;
  }
}

/// Joins the bodies that contacts and links move together.
template <int D>
void World<D>::join(const std::vector<Contact>& contacts) {
  joined_.begin(bodies.size());
  for (const Contact& c : contacts)
    if (c.antagonist >= 0 && bodies[c.candidate].moves() && bodies[c.antagonist].moves())
      joined_.join(c.candidate, c.antagonist);
  links.join(bodies, joined_);
}

template <int D>
int World<D>::island_of(const Contact& c) {
  return joined_.island(bodies[c.candidate].moves() ? c.candidate : c.antagonist);
}

/// The impacts of an instant. Only contacts that rest or approach bear impulses, because one that separates
/// takes up energy if it is held: v_n^- > 0 and v_n^+ >= 0 give r_n (v_n^- + v_n^+)/2 > 0. What approaches
/// afterwards is the next impact, with these velocities as v^-. After most_together of them the rest has e =
/// 0 and holds all contacts, which ends it without a gain. False if nothing approaches.
template <int D>
bool World<D>::collide_together() {
  const auto separates = [&](const Contact& c) { return relative_velocity(c)[0] > 0; };
  const bool is_one_island = contacts_.size() <= 1 || bodies.size() == 1;
  if (is_one_island && (contacts_.size() <= 1 || std::none_of(contacts_.begin(), contacts_.end(), separates)))
    return solve_impact();
  closed_ = contacts_;
  closed_states_.assign(closed_.size(), {});
  for (std::size_t a = 0; a < closed_.size(); ++a) {
    Contact& c = closed_[a];
    if (c.impulse[0] > 0) closed_states_[a].drift = std::max(0.0, relative_velocity(c)[0]);
    c.impulse.setZero();
    c.speed_scale = g_ * settings_.time_step;
    c.manifold = -1;
  }
  bool approaching = false;
  double spring_rate = 0, longest_of_dampers = infinite;
  for (int hits = 0; choose_bearers(hits == 0); ++hits) {
    const bool plastic = hits == most_together;
    if (plastic) {
      contacts_ = closed_;
      drifts_.clear();
      ++quality_.endless_impacts;
    }
    const bool solved = solve_impact(plastic);
    approaching = approaching || solved;
    if (contacts_.size() == closed_.size()) return approaching;
    spring_rate = std::max(spring_rate, spring_rate_);
    longest_of_dampers = std::min(longest_of_dampers, longest_of_dampers_);
    take_back_bearers();
  }
  contacts_ = closed_;
  after_.resize(contacts_.size());
  for (std::size_t a = 0; a < contacts_.size(); ++a) after_[a] = relative_velocity(contacts_[a]);
  spring_rate_ = spring_rate;
  longest_of_dampers_ = longest_of_dampers;
  return approaching;
}

/// The speeds below which a closed contact rests: a share of the greatest speed of its island, to which its
/// velocity is known.
template <int D>
void World<D>::measure_rest() {
  constexpr double rounding = 1e-10;
  join(closed_);
  islands_at_instant_.assign(bodies.size(), {});
  const auto speed = [&](int i) { return bodies[i].v.norm() + bodies[i].size * bodies[i].spin_speed(); };
  for (const Contact& c : closed_) {
    IslandAtInstant& island = islands_at_instant_[island_of(c)];
    ++island.contacts;
    island.speed = std::max(island.speed, speed(c.candidate));
    if (c.antagonist >= 0) island.speed = std::max(island.speed, speed(c.antagonist));
  }
  for (std::size_t a = 0; a < closed_.size(); ++a) {
    const IslandAtInstant& island = islands_at_instant_[island_of(closed_[a])];
    ClosedState& state = closed_states_[a];
    state.rest = (island.contacts <= few_contacts ? rounding : settings_.tolerance) * island.speed;
    state.normal_speed = relative_velocity(closed_[a])[0];
  }
}

/// Puts into contacts_ those of closed_ that bear impulses in the next impact: those that rest or approach,
/// of the islands of such contacts in which one approaches, faster than a step leaves open, that has not been
/// solved with its present velocity. The first impact has the islands with springs, too, because they limit
/// the next step. False if there is no next impact.
template <int D>
bool World<D>::choose_bearers(bool first) {
  measure_rest();
  const double left_open = settings_.tolerance * g_ * settings_.time_step;
  const auto bears = [](const ClosedState& s) { return s.normal_speed <= std::max(s.rest, s.drift); };
  contacts_.clear();
  for (std::size_t a = 0; a < closed_.size(); ++a)
    if (bears(closed_states_[a])) contacts_.push_back(closed_[a]);
  join(contacts_);
  islands_at_instant_.assign(bodies.size(), {});
  for (std::size_t a = 0; a < closed_.size(); ++a) {
    const ClosedState& s = closed_states_[a];
    const bool approaches = s.normal_speed < -std::max({s.rest, s.drift, left_open}) && !s.solved;
    const PairLaws* laws = closed_[a].laws;
    const bool may_be_spring = first && laws && laws->unilateral.law;
    if (approaches || may_be_spring) islands_at_instant_[island_of(closed_[a])].approaches = true;
  }
  contacts_.clear();
  bearers_.clear();
  drifts_.clear();
  for (std::size_t a = 0; a < closed_.size(); ++a) {
    const ClosedState& s = closed_states_[a];
    if (!bears(s) || !islands_at_instant_[island_of(closed_[a])].approaches) continue;
    bearers_.push_back(static_cast<int>(a));
    contacts_.push_back(closed_[a]);
    drifts_.push_back(s.normal_speed > s.rest);
  }
  return !contacts_.empty();
}

/// Takes what the last impact has made of its contacts back into closed_, and notes which closed contacts are
/// solved: those of the impact, until another one changes the velocity of their bodies.
template <int D>
void World<D>::take_back_bearers() {
  touching_.assign(bodies.size(), false);  // those that the impact has moved
  for (std::size_t k = 0; k < bearers_.size(); ++k) {
    const Contact& c = closed_[bearers_[k]] = contacts_[k];
    if (c.impulse.isZero(0)) continue;
    for (const int i : {c.candidate, c.antagonist})
      if (i >= 0 && bodies[i].moves()) touching_[i] = true;
  }
  for (std::size_t a = 0; a < closed_.size(); ++a) {
    const Contact& c = closed_[a];
    if (touching_[c.candidate] || (c.antagonist >= 0 && touching_[c.antagonist]))
      closed_states_[a].solved = false;
  }
  for (const int a : bearers_) closed_states_[a].solved = true;
}

/// Whether a contact that may collide is a spring. The law is asked only if it can be one.
template <int D>
bool World<D>::is_spring(Contact& contact) {
  if (!contact.laws || !contact.laws->unilateral.law) return false;
  contact.before = relative_velocity(contact);
  contact.manifold = -1;
  ask_law(contact, 0);
  return contact.law.condition == NormalCondition::penalty;
}

/// Lets the closed contacts collide one after the other, the fastest approach first, each by its law. Springs
/// do nothing at an instant. False if that does not end.
template <int D>
bool World<D>::collide_one_by_one() {
  closed_ = contacts_;
  springs_.assign(closed_.size(), false);
  for (std::size_t a = 0; a < closed_.size(); ++a) springs_[a] = is_spring(closed_[a]);
  bool ends = true;
  for (int hits = 0;; ++hits) {
    std::size_t next = closed_.size();
    double fastest = settings_.rest_speed;
    for (std::size_t a = 0; a < closed_.size(); ++a) {
      const double approach = springs_[a] ? 0 : -relative_velocity(closed_[a])[0];
      if (approach > fastest) fastest = approach, next = a;
    }
    if (next == closed_.size()) break;
    ends = hits < most_hits;
    if (!ends) break;
    contacts_.assign(1, closed_[next]);
    solve_impact();
    closed_[next].history = contacts_[0].history;
  }
  contacts_ = closed_;
  return ends;
}

#define FLYROCK_INSTANTIATE(D)                   \
  template World<D>::Outcome World<D>::impact(); \
  template void World<D>::pull_links();          \
  template bool World<D>::collide_together();    \
  template bool World<D>::choose_bearers(bool);  \
  template void World<D>::take_back_bearers();   \
  template void World<D>::set_rest_at_impact(bool)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
