// Calls the laws of the contacts at the start of a step or impact.

#include <algorithm>
#include <cmath>

#include "collision/manifold_reduction.h"
#include "world/corners.h"
#include "world/manifold.h"
#include "world/proportions.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// A law of form `velocity` gives the whole velocity after an impact, which only one contact of a body can
/// have. It goes to the deepest contact of the instant; the others have e = 0. Corners would touch several at
/// once. `chosen` [body] is overwritten.
template <int D>
void choose_struck(std::vector<WorldContact<D>>& contacts, const std::vector<Body<D>>& bodies,
                   std::vector<char>& chosen) {
  using Contact = WorldContact<D>;
  const auto is_struck = [](const Contact& c) {
    return c.manifold >= 0 && c.law.form == RestitutionForm::velocity;
  };
  if (std::none_of(contacts.begin(), contacts.end(), is_struck)) return;
  chosen.assign(bodies.size(), false);  // bodies with a contact that has the law
  const auto moves = [&](int i) { return i >= 0 && bodies[i].moves(); };
  const auto has_chosen = [&](const Contact& c) {
    return (moves(c.candidate) && chosen[c.candidate]) || (moves(c.antagonist) && chosen[c.antagonist]);
  };
  for (;;) {
    const Contact* deepest = nullptr;
    for (const Contact& c : contacts)
      if (is_struck(c) && !has_chosen(c) && (!deepest || c.at.gap < deepest->at.gap)) deepest = &c;
    if (!deepest) return;
    for (const int i : {deepest->candidate, deepest->antagonist}) {
      if (!moves(i)) continue;
      if (has_corners(bodies[i])) throw TrialError(corners_text(bodies[i].group));
      chosen[i] = true;
    }
    for (Contact& c : contacts)
      if (&c != deepest && is_struck(c) && has_chosen(c)) static_cast<Restitution&>(c.law) = {};
  }
}

}  // namespace

template <int D>
int World<D>::rock_of(int first, int second) const {
  constexpr double rounding = 1e-9;  // the order of the bodies changes the last digits of an energy
  if (second < 0) return first;
  const Body<D>&a = bodies[first], &b = bodies[second];
  const double energy_a = a.kinetic_energy(), energy_b = b.kinetic_energy();
  bool is_second = false;
  if (a.moves() != b.moves())
    is_second = b.moves();
  else if (a.mass != b.mass)
    is_second = b.mass < a.mass;
  else if (a.radius != b.radius)
    is_second = b.radius < a.radius;
  else if (std::abs(energy_a - energy_b) > rounding * std::max(energy_a, energy_b))
    is_second = energy_b < energy_a;
  else
    is_second = b.group < a.group;
  return is_second ? second : first;
}

template <int D>
ContactState World<D>::state_of(const Contact& contact, double h) {
  const int rock = contact.manifold >= 0 ? contact.rock : rock_of(contact.candidate, contact.antagonist);
  const Body<D>& body = bodies[rock];
  const double side = rock == contact.candidate ? 1 : -1;  // normal and velocities are those of the candidate
  ContactState state;
  state.approach_speed = contact.approach();
  state.slip_speed = tangential(contact.before).norm();
  state.impact_angle = std::atan2(state.approach_speed, state.slip_speed);
  state.gap = contact.at.gap;
  double inverse_mass = 0;
  for (const int i : {contact.candidate, contact.antagonist}) {
    if (i < 0) continue;
    const typename Body<D>::Rows normal =
        contact_columns<D>(contact.at.normal, contact.at.point - bodies[i].x).col(0);
    inverse_mass += normal.dot(bodies[i].inverse_mass_times(normal));
  }
  state.effective_mass = 1 / inverse_mass;
  state.mass = body.mass;
  state.radius = body.radius;
  state.spin = body.spin_speed();
  state.kinetic_energy = body.kinetic_energy();
  patch_.clear();
  std::size_t which = 0;
  for (const Contact& other : contacts_) {
    if (other.laws == contact.laws) state.pair_age = std::max(state.pair_age, other.age);
    if (&other == &contact) which = patch_.size();
    if (other.candidate == contact.candidate && other.antagonist == contact.antagonist &&
        same_direction<D>(other.at.normal, contact.at.normal))
      patch_.push_back(other.at.point);
  }
  if constexpr (D == 2) {
    // The tributary length of this point is half its distance to the other point of the same manifold.
    for (const Vec<D>& point : patch_) state.length += 0.5 * (point - contact.at.point).norm();
    state.area = state.length * body.volume / (pi * body.radius * body.radius);
  } else {
    state.area = tributary_area(patch_, which, contact.at.normal) + contact.at.dropped_area;
  }
  state.age = contact.age;
  state.was_sticking = contact.sticking;
  state.impact_number = contact.manifold >= 0 ? contact.impact_number : body.impacts;
  state.time = settling ? 0 : time;
  state.step = h;
  state.dimension = D;
  state.normal = Vec3::Zero();
  state.normal.template head<D>() = side * contact.at.normal;
  state.place.template head<D>() = contact.at.point + origin;
  state.slip.template head<D>() =
      side * contact_frame(contact.at.normal).template rightCols<D - 1>() * tangential(contact.before);
  const ContactReads& reads = contact.laws->reads();
  if (reads.normal_force && contact.manifold < 0) state.normal_force = contact.normal_force;
  if (reads.points) state.points = static_cast<double>(patch_.size());
  if (reads.slip_length) state.slip_length = contact.slip_length;
  if (reads.shape) set_shape(state, rock);
  if (reads.partner) set_partner(state, contact.other_than(rock));
  state.group_a = body.group;
  if (contact.antagonist >= 0)
    state.group_b = bodies[contact.other_than(rock)].group;
  else
    state.group_b = terrain_->names()[part_of(*terrain_, contact.at.against)];
  state.material = contact.laws->material;
  return state;
}

template <int D>
void World<D>::set_shape(ContactState& state, int rock) {
  Body<D>& body = bodies[rock];
  if (!body.proportions) body.proportions = proportions_of(body);
  put_shape(body, *body.proportions, state);
}

template <int D>
void World<D>::set_partner(ContactState& state, int partner) const {
  if (partner < 0) return;
  const Body<D>& body = bodies[partner];
  state.partner_moves = body.moves();
  state.partner_radius = body.radius;
  if (body.moves()) state.partner_mass = body.mass;
}

/// Groups the contacts that close faster than rest_speed into manifolds, and counts each manifold as one
/// impact of its bodies.
template <int D>
void World<D>::begin_manifolds() {
  int manifolds = 0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& contact = contacts_[i];
    contact.manifold = -1;
    if (contact.approach() <= settings_.rest_speed) continue;
    if (contact.law.condition == NormalCondition::penalty && contact.age > 0)
      continue;  // a spring that was compressed before has no new impact
    for (std::size_t k = 0; k < i && contact.manifold < 0; ++k) {
      const Contact& other = contacts_[k];
      if (other.manifold >= 0 && other.candidate == contact.candidate &&
          other.antagonist == contact.antagonist && same_direction<D>(other.at.normal, contact.at.normal))
        contact.manifold = other.manifold, contact.rock = other.rock,
        contact.impact_number = other.impact_number;
    }
    if (contact.manifold >= 0) continue;
    contact.manifold = manifolds++;
    count_impact(contact);
  }
}

template <int D>
void World<D>::count_impact(Contact& contact) {
  for (const int i : {contact.candidate, contact.antagonist})
    if (i >= 0) ++bodies[i].impacts;
  contact.rock = rock_of(contact.candidate, contact.antagonist);
  contact.impact_number = bodies[contact.rock].impacts;
}

template <int D>
void World<D>::ask_law(Contact& contact, double h) {
  PairLaws* laws = contact.laws;
  if (!laws) {
    contact.law = {};
    return;
  }
  ++laws->use.contacts;
  const bool impact = contact.manifold >= 0;
  if (impact) laws->begin_impact(contact.impact_number, contact.rock == contact.antagonist);
  if (const ContactLaw* known = impact ? nullptr : laws->known()) {
    contact.law = *known;
  } else {
    ContactState state;
    if (laws->reads_state()) state = state_of(contact, h);
    contact.law = laws->ask(state, impact, contact.history);
  }
  if (laws->mu) contact.law.mu_s = contact.law.mu_d = laws->mu->at(settling ? 0 : time + 0.5 * h).x();
  // The waves of a deformable block are its restitution.
  if (settling || deforms(contact)) static_cast<Restitution&>(contact.law) = {};
}

/// Impacts come first, because a resting contact uses the values that were drawn for the last impact of its
/// pair.
template <int D>
void World<D>::ask_laws(double h) {
  for (PairLaws* laws : laws_) laws->begin_instant();
  for (const bool impacts : {true, false})
    for (Contact& contact : contacts_)
      if ((contact.manifold >= 0) == impacts) ask_law(contact, h);
  choose_struck(contacts_, bodies, touching_);
}

#define FLYROCK_INSTANTIATE(D)                                      \
  template ContactState World<D>::state_of(const Contact&, double); \
  template void World<D>::set_shape(ContactState&, int);            \
  template void World<D>::set_partner(ContactState&, int) const;    \
  template int World<D>::rock_of(int, int) const;                   \
  template void World<D>::begin_manifolds();                        \
  template void World<D>::count_impact(Contact&);                   \
  template void World<D>::ask_law(Contact&, double);                \
  template void World<D>::ask_laws(double);
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
