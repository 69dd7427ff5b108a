// The step of a dense world: many bodies that touch, in steps of one length that no touch cuts.
//
// Contacts within reach of the step enter with the gap of its start. With v_free = v + h (g + a_air):
//   v+ = v_free + M^-1 H r,   0 <= u_n+ + max(0, gap)/h  _|_  r_n >= 0,   Coulomb friction on u_t+
//   q+ = q + h v+
// A contact that closes within the step faster than rest_speed, under a law that bounces, collides at the
// time t of its touch along the free path, with the velocity there: the law holds for
//   u(t)+ = u+ - (u_free - u) (h - t)/h,
// unless it would fall again by the end of the step, and its bodies, if nothing else pushes them, move along
// their free paths until t. A body that no contact pushes flies along its parabola. Overlap that is left is
// projected out. Features that end deeper than `slop` and were not among the contacts join them, and the step
// is made again. It is halved where none joins, and every other time.
//
// Of first order. Sources: D. Stewart and J. Trinkle 1996; gaps as M. Anitescu and A. Tasora 2010.

#include <algorithm>
#include <span>
#include <utility>

#include "math/travel_time.h"
#include "world/same_contact.h"
#include "world/world.h"

namespace flyrock {

namespace {

constexpr int becomes_dense = 40, becomes_exact = 20;  // contacts of an island
constexpr int no_partner = -2, several = -3;           // in place of a body or, -1, the terrain

/// The order of the contacts of a step.
template <int D>
bool is_before(const WorldContact<D>& a, const WorldContact<D>& b) {
  return std::pair(a.candidate, a.antagonist) < std::pair(b.candidate, b.antagonist);
}

/// Those of a step's contacts that are of the same two bodies as one.
template <int D>
std::span<const WorldContact<D>> of_pair(const std::vector<WorldContact<D>>& contacts,
                                         const WorldContact<D>& contact) {
  const auto [begin, end] = std::equal_range(contacts.begin(), contacts.end(), contact, is_before<D>);
  return {begin, end};
}

}  // namespace

template <int D>
bool World<D>::can_be_dense() const {
  return settings_.many != ManyBodies::exact && !settings_.one_by_one && bodies_meet() && !has_springs_ &&
         !deforms_ && links.empty() &&
         std::none_of(bodies.begin(), bodies.end(), [](const Body<D>& b) { return b.breathing.moves(); });
}

/// The number of contacts of the island that has most. An island: bodies that may meet within a dense step,
/// by their swept boxes, directly or through others; its contacts: those within reach of a dense step, of the
/// last one or, where the world is not dense yet, of one from here.
template <int D>
int World<D>::most_contacts_of_island() {
  constexpr std::size_t most_of_pair = D == 2 ? 2 : 4, becomes = becomes_dense;
  if (!dense_ && 4 * contacts_.size() < becomes) return 0;  // so few touch that none of them is a pile
  const auto& pairs = near_pairs(settings_.dense_step);
  if (!dense_ && most_of_pair * (pairs.size() + bodies.size()) < becomes) return 0;
  joined_.begin(bodies.size());
  for (const auto& [i, j] : pairs)
    if (bodies[i].moves() && bodies[j].moves()) joined_.join(i, j);
  contacts_of_island_.assign(bodies.size(), 0);
  int most = 0;
  const auto count = [&] {
    for (const Contact& c : contacts_) {
      const int mover = bodies[c.candidate].moves() ? c.candidate : c.antagonist;
      most = std::max(most, ++contacts_of_island_[joined_.island(mover)]);
    }
  };
  if (dense_)
    count();
  else
    see_ahead(settings_.dense_step, count);
  return most;
}

/// Calls use() while contacts_ are those within reach of a dense step of length h from here.
template <int D>
template <class Use>
void World<D>::see_ahead(double h, Use use) {
  const bool was_dense = dense_;
  dense_ = true;
  ahead_ = h;
  solved_.swap(contacts_);
  find_contacts(h);
  use();
  solved_.swap(contacts_);
  dense_ = was_dense;
}

/// Chooses how the next step is made.
template <int D>
void World<D>::choose_density() {
  const bool was_dense = dense_;
  dense_ = can_be_dense() && (settings_.many == ManyBodies::dense ||
                              most_contacts_of_island() >= (dense_ ? becomes_exact : becomes_dense));
  if (was_dense == dense_) return;
  forget_steps();
  reach_time_ = dense_ ? 0 : settings_.time_step;
  std::erase_if(contacts_, [](const Contact& c) { return !c.carried; });
  last_ = contacts_;
}

/// The length of a dense step [s]: the given one; no body moves further than a share of its size.
template <int D>
double World<D>::dense_length() const {
  constexpr double most_travel = 0.4;  // of the size: with the reach, no body passes through another unseen
  double h = settings_.dense_step;
  for (const Body<D>& body : bodies)
    if (body.moves())
      h = std::min(h, most_travel * body.size / (body.v.norm() + body.spin_speed() * body.size));
  return h;
}

/// How far a body may come nearer to others in a step of length ahead_ [m].
template <int D>
double World<D>::travel_ahead(const Body<D>& body) const {
  constexpr double safety = 1.1;
  if (body.kind == BodyKind::fixed) return 0;
  return safety * ahead_ * (body.v.norm() + body.spin_speed() * body.size) +
         (body.moves() ? g_ * ahead_ * ahead_ : 0);
}

/// The gap up to which a contact enters a dense step.
template <int D>
double World<D>::reach_ahead(int candidate, int antagonist) const {
  constexpr double most = 0.2;  // of the size
  double travel = travel_ahead(bodies[candidate]);
  travel += antagonist >= 0 ? travel_ahead(bodies[antagonist]) : g_ * ahead_ * ahead_;
  return std::min(travel, most * contact_size(candidate, antagonist));
}

/// Gives the bodies their free velocities, and finds when the contacts close along the free paths.
template <int D>
void World<D>::foresee_touches(double h) {
  for (Contact& c : contacts_) {
    c.before = relative_velocity(c);
    c.turning.setZero();
    c.lasts = false;
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body<D>& body = bodies[i];
    body.v += h * body.acceleration(gravity_);
    if (body.moves()) body.w = free_spin(body, h, 1, Space<D>::no_spin());
    free_[i] = body.velocity();
  }
  gained_in_step_.resize(contacts_.size());
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& c = contacts_[a];
    c.touch = 0;
    Row& gain = gained_in_step_[a] = relative_velocity(c) - c.before;
    const double t = travel_times(std::max(0.0, c.at.gap), -c.before[0], -gain[0] / h)[0];
    const Row at_touch = c.before + t / h * gain;
    c.stays_apart = !(t <= h && at_touch[0] < -settings_.rest_speed);
    if (c.stays_apart) continue;
    c.touch = t;
    c.before = at_touch;
  }
}

/// Asks the laws of the contacts that close in the step. Only what is closed has cohesion. A contact whose
/// rebound would be a fall again at the end of the step does not bounce: it would close there, and bounce
/// again in each step that follows. Returns false if a spring is among the contacts.
template <int D>
bool World<D>::ask_dense_laws(double h) {
  begin_manifolds();
  ask_laws(h);
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& c = contacts_[a];
    if (c.law.condition == NormalCondition::penalty) return false;
    if (c.at.gap > slop * contact_size(c.candidate, c.antagonist)) c.law.c_n = c.law.c_t = 0;
    const double at_end = c.law.e_n * c.approach() + (h - c.touch) / h * gained_in_step_[a][0];
    c.bounces = !c.stays_apart && at_end > 0;
    if (!c.bounces) c.law.e_n = 0;
  }
  return true;
}

/// Writes gaps and touches into the problem.
template <int D>
void World<D>::put_gaps(double h) {
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const Contact& c = contacts_[a];
    Row& q = problem_.contacts[a].q;
    if (c.bounces)
      q -= (h - c.touch) / h * gained_in_step_[a];
    else if (c.law.condition != NormalCondition::quasi_shock)  // it has its gap by its law
      q[0] += std::max(0.0, c.at.gap) / h;
  }
}

/// When each body bounces off the only body, or the terrain, that pushes it, and which has no other contact
/// either [s]; infinite: it does not. Bodies with more contacts move as the scheme has it: along their free
/// paths they would come into what holds them.
template <int D>
void World<D>::find_lone_bounces() {
  partner_.assign(bodies.size(), no_partner);
  bounce_.assign(bodies.size(), infinite);
  for (const Contact& c : contacts_) {
    if (c.impulse.isZero(0)) continue;
    for (const int i : {c.candidate, c.antagonist}) {
      if (i < 0) continue;
      const int other = c.other_than(i);
      partner_[i] = c.bounces && (partner_[i] == no_partner || partner_[i] == other) ? other : several;
      bounce_[i] = std::min(bounce_[i], c.touch);
    }
  }
  const auto is_alone = [&](int i) { return i < 0 || !bodies[i].moves() || partner_[i] != several; };
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (partner_[i] == no_partner || partner_[i] == several || !is_alone(partner_[i])) bounce_[i] = infinite;
}

/// Moves the bodies to the end of the step.
template <int D>
void World<D>::move_densely(double h) {
  find_lone_bounces();
  theta_loss_ = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body<D>& body = bodies[i];
    if (!body.present || body.kind == BodyKind::fixed) continue;
    const bool is_pushed = partner_[i] != no_partner;
    typename Body<D>::Rows before;
    before << starts_[i].v, starts_[i].w;
    const typename Body<D>::Rows after = body.velocity();
    if (!body.moves() || !is_pushed) {
      body.displace(0.5 * h * (before + after));
    } else if (const double t = bounce_[i]; t <= h) {
      const typename Body<D>::Rows gain = free_[i] - before;
      body.displace(t * (before + 0.5 * t / h * gain) + (h - t) * (after - 0.5 * (h - t) / h * gain));
    } else {
      body.displace(h * after);
      theta_loss_ += 0.5 * h * body.mass * (gravity_ + body.push).dot(body.v - starts_[i].v);
    }
  }
}

/// The deepest contact of the present places that the step of length h has not solved, as a share of the
/// size. Those deeper than `slop` are noted in unseen_, with the gap that they had at its start by their
/// speed now: there, their features may have been beside each other.
template <int D>
double World<D>::unsolved_depth(double h) {
  double deepest = 0;
  see_ahead(0, [&] {
    for (const Contact& c : contacts_) {
      const double depth = -c.at.gap / contact_size(c.candidate, c.antagonist);
      if (depth <= std::min(deepest, slop) || has_same(of_pair(solved_, c), c)) continue;
      deepest = std::max(deepest, depth);
      if (depth > slop) unseen_.emplace_back(c).at.gap -= h * relative_velocity(c)[0];
    }
  });
  return deepest;
}

/// Finds the contacts of a dense step of length h. Features that an end of this step has shown in each other,
/// although no search at its start finds them, join those of their pair.
template <int D>
void World<D>::find_dense_contacts(double h) {
  const PhaseTimer timer(clock, &PhaseTimes::detect);
  ahead_ = h;
  find_contacts(h);
  for (const Contact& c : unseen_) {
    if (has_same(of_pair(contacts_, c), c)) continue;
    const auto after_pair = std::upper_bound(contacts_.begin(), contacts_.end(), c, is_before<D>);
    contacts_.insert(after_pair, c);
  }
  match_last();
}

/// Starts a try of length h from the impulses that the try before, of length `before`, has found.
template <int D>
void World<D>::start_from_last_try(double h, double before) {
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const auto tried = of_pair(tried_, contacts_[a]);
    const auto same = std::find_if(tried.begin(), tried.end(),
                                   [&](const Contact& other) { return is_same(other, contacts_[a]); });
    if (same != tried.end()) impulses_[a] = h / before * same->impulse;
  }
}

template <int D>
typename World<D>::Outcome World<D>::dense_step(double h) {
  constexpr double most_sunk = 5e-4;  // of the size, of a solved contact
  constexpr int most_tries = 8;
  free_.resize(bodies.size());
  impacts_.clear();
  save();
  unseen_.clear();
  tried_.clear();
  const double allowed = std::max(most_sunk, sunk_share_);  // what the last step has left
  double unsolved = 0, before = h;
  for (int tries = 1;; ++tries) {
    find_dense_contacts(h);
    foresee_touches(h);
    if (!ask_dense_laws(h)) {
      restore();
      has_springs_ = true;
      choose_density();
      return {0, false, true};
    }
    assemble(h, last_step_ > 0 ? h / last_step_ : 1);
    start_from_last_try(h, before);
    put_gaps(h);
    last_solve_ = {};
    pressed_.clear();
    if (!contacts_.empty()) solve_and_apply();
    move_densely(h);
    measure_after(h);
    for (std::size_t a = 0; a < contacts_.size(); ++a)
      if (contacts_[a].bounces) after_[a] -= (h - contacts_[a].touch) / h * gained_in_step_[a];
    const double energy = total_energy();
    project_drift(true);
    const double lifted = total_energy() - energy;
    const std::size_t known = unseen_.size();
    unsolved = unsolved_depth(h);
    if ((unsolved <= slop && sunk_share_ <= allowed) || tries == most_tries) {
      quality_.max_penetration = std::max(quality_.max_penetration, sunk_);
      quality_.projection_energy += lifted;
      quality_.theta_loss += theta_loss_;
      energy_in_doubt_ += std::max(0.0, lifted - theta_loss_);
      break;
    }
    restore();
    tried_.swap(contacts_);
    before = h;
    if (unseen_.size() == known || tries % 2 == 0) h /= 2;
    ++quality_.refused_steps;
  }
  quality_.unsolved_depth = std::max(quality_.unsolved_depth, unsolved);
  record_impacts();
  audit_energy(h);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) energy_given_ += bodies[i].mass * bodies[i].push.dot(bodies[i].x - starts_[i].x);
  time += h;
  last_step_ = h;
  finish_bodies();
  ++quality_.dense_steps;
  quality_.count_step(h, false);
  const Outcome outcome = keep(h, false);
  forget_steps();
  choose_density();
  return {outcome.duration, false, dense_ || outcome.in_contact};
}

#define FLYROCK_INSTANTIATE(D)                                  \
  template bool World<D>::can_be_dense() const;                 \
  template void World<D>::choose_density();                     \
  template double World<D>::dense_length() const;               \
  template double World<D>::travel_ahead(const Body<D>&) const; \
  template double World<D>::reach_ahead(int, int) const;        \
  template World<D>::Outcome World<D>::dense_step(double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
