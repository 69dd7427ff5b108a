// Contact detection: contacts within reach, matched with the contacts of the last step.

#include <algorithm>

#include "collision/pairs.h"
#include "world/manifold.h"
#include "world/same_contact.h"
#include "world/world.h"

namespace flyrock {

namespace {

// A contact that carried an impulse in the last step stays active up to a gap of this share of its size. If a
// sliding contact is missed for one step, its velocity error is mu g h.
constexpr double carry_share = 1e-6;

}  // namespace

template <int D>
double World<D>::contact_size(int candidate, int antagonist) const {
  const Body<D>& a = bodies[candidate];
  if (antagonist < 0) return a.size;
  const Body<D>& b = bodies[antagonist];
  return !a.moves() ? b.size : !b.moves() ? a.size : std::min(a.size, b.size);
}

/// A body that keeps contact by its curvature, or while it turns about a vertex, opens a gap of at most g h^2
/// / 8 in half a step of length h before it leaves the ground.
template <int D>
double World<D>::reach_within(double h, int candidate, int antagonist) const {
  return carry_share * contact_size(candidate, antagonist) + 0.25 * g_ * h * h;
}

template <int D>
double World<D>::carry_reach(int candidate, int antagonist) const {
  return reach_within(reach_time_, candidate, antagonist);
}

/// The gap that a contact which is closed at the start of a step may have in its middle: carry_reach, and
/// what the gyroscopic moment of its bodies holds closed as their weight does. One end of a log that rolls
/// and yaws rises by many times g h^2 / 8 in half a step, while its load holds it down.
template <int D>
double World<D>::reach_in_middle(int candidate, int antagonist) const {
  constexpr double most = 1e-3;  // of the size
  double reach = carry_reach(candidate, antagonist);
  for (const int i : {candidate, antagonist})
    if (i >= 0 && bodies[i].moves())
      reach += bodies[i].size * std::min(most, 0.25 * reach_time_ * reach_time_ * free_spin_rate(bodies[i]));
  return reach;
}

template <int D>
const std::vector<std::pair<int, int>>& World<D>::near_pairs(double dt) {
  boxes_.clear();
  for (std::size_t i = 0; i < bodies.size() && bodies_meet(); ++i)
    boxes_.push_back(swept_box<D>(Path<D>{bodies[i].x, bodies[i].v, bodies[i].acceleration(gravity_)},
                                  bodies[i].size * (1 + carry_share), dt));
  return broad_phase_.template pairs<D>(boxes_);
}

/// The pairs of bodies that are now within reach of each other.
template <int D>
const std::vector<std::pair<int, int>>& World<D>::close_pairs() {
  boxes_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto pose = bodies[i].pose();
    const double reach = reach_of_step(static_cast<int>(i), -1);
    auto& box = boxes_.emplace_back(typename Geometry<D>::Box{pose.x, pose.x});
    for (const auto& contactor : bodies[i].contactors) {
      const auto core = core_box(Placed<D>{contactor, pose});
      box.add(core.grown(contactor.radius + reach));
    }
  }
  return broad_phase_.template pairs<D>(boxes_);
}

/// The gap up to which contacts are sought.
template <int D>
double World<D>::reach_of_step(int candidate, int antagonist) const {
  return dense_ ? reach_ahead(candidate, antagonist) : reach_in_middle(candidate, antagonist);
}

/// `ahead` [s]: the time by which the bodies have been moved since the start of the step, or move in a dense
/// one. An edge may have left the cone of a corner or edge of the ground during this time.
template <int D>
void World<D>::detect(double ahead) {
  const PhaseTimer timer(clock, &PhaseTimes::detect);
  find_contacts(ahead);
  match_last();
}

/// Fills points_ with the contacts of a body with the terrain (`other`: -1), or with another one, at these
/// poses, up to a gap of `reach` [m].
template <int D>
void World<D>::find_points(int body, int other, const Pose& pose, const Pose& of_other, double reach,
                           double ahead) {
  const Body<D>& a = bodies[body];
  points_.clear();
  if (other < 0) {
    near_parts(work_, a.parts, pose, *terrain_, reach + slack(body), parts_);
    for (const int k : parts_)
      terrain_contacts<D>(work_, Placed<D>{a.contactors[k], pose, k}, *terrain_, reach,
                          a.spin_speed() * ahead, points_);
    return;
  }
  const Body<D>& b = bodies[other];
  near_parts(work_, a.parts, pose, b.parts, of_other, reach + slack(body) + slack(other), part_pairs_);
  for (const auto& [k, l] : part_pairs_)
    body_contacts(work_, Placed<D>{a.contactors[k], pose, k}, Placed<D>{b.contactors[l], of_other, l}, reach,
                  points_, (a.spin_speed() + b.spin_speed()) * ahead);
}

/// Appends the contacts of a body with the terrain, or of two bodies, where they are now.
template <int D>
void World<D>::find_between(int candidate, int antagonist, double ahead) {
  if (antagonist >= 0 && !may_touch(candidate, antagonist)) return;
  const Pose pose = bodies[candidate].pose();
  find_points(candidate, antagonist, pose, antagonist < 0 ? pose : bodies[antagonist].pose(),
              reach_of_step(candidate, antagonist), ahead);
  append_points(candidate, antagonist);
}

/// Makes contacts of the points that were found.
template <int D>
void World<D>::append_points(int candidate, int antagonist) {
  for (const ContactPoint<D>& point : points_) {
    Contact& contact = contacts_.emplace_back();
    contact.at = point;
    contact.candidate = candidate;
    contact.antagonist = antagonist;
    contact.laws = antagonist < 0 ? terrain_laws_[candidate][part_of(*terrain_, point.against)]
                                  : pair_laws(candidate, antagonist);
  }
}

template <int D>
void World<D>::find_contacts(double ahead) {
  contacts_.clear();
  // Contacts are sorted by candidate, with the terrain first and then the antagonists in their order. NLGS
  // sweeps in this order, and match_last needs it.
  static const std::vector<std::pair<int, int>> none;
  const auto& pairs = bodies_meet() ? close_pairs() : none;
  auto pair = pairs.begin();
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    if (bodies[i].moves()) find_between(i, -1, ahead);
    for (; pair != pairs.end() && pair->first == i; ++pair) find_between(i, pair->second, ahead);
  }
}

/// The contact of the last step that this contact continues: the one with the same features; otherwise the
/// one of the same vertex or edge on the next segment of the terrain or of an outline; otherwise the nearest.
/// The last two are taken only if their own features are no longer in contact: an edge that rests on one edge
/// of the terrain passes its memory to none of the neighbours that it is near. The last rule is for surfaces
/// that lie flush with their corners on each other, because rounding then decides which features are found.
template <int D>
const typename World<D>::Contact* World<D>::carried_on(const Contact& contact, std::span<const Contact> last,
                                                       std::span<const Contact> now) const {
  constexpr double same_place = 1e-3;  // of the size
  const auto passed_on = [&](const ContactPoint<D>& from, const ContactPoint<D>& to) {
    if (contact.antagonist < 0)
      return from.feature == to.feature && next_to(*terrain_, from.against, to.against);
    const Body<D>&a = bodies[contact.candidate], &b = bodies[contact.antagonist];
    if (b.is_outline())
      return from.feature == to.feature && next_to(*b.contactors[0].ground, from.against, to.against);
    return a.is_outline() && from.against == to.against &&
           next_to(*a.contactors[0].ground, from.feature, to.feature);
  };
  const Contact* found = nullptr;
  for (const Contact& old : last) {
    if (is_same(old, contact)) return &old;
    if (same_direction<D>(old.at.normal, contact.at.normal) && passed_on(old.at, contact.at) &&
        !has_same(now, old))
      found = &old;
  }
  if (found) return found;
  double nearest = same_place * contact_size(contact.candidate, contact.antagonist);
  for (const Contact& old : last) {
    const double distance = (old.at.point - contact.at.point).norm();
    if (distance > nearest || !same_direction<D>(old.at.normal, contact.at.normal) || has_same(now, old))
      continue;
    nearest = distance;
    found = &old;
  }
  return found;
}

/// The overlap from which a spring of `penalty` counts that begins now [m]. While springs yield, other places
/// of their bodies lie as deep in each other, and their features may come to face each other only then, as an
/// edge and a corner over which it turns. A spring that began with all of this overlap would give energy that
/// nobody has put in. What the place can have closed in two steps, and what the contacts had that end now,
/// does not count.
template <int D>
double World<D>::overlap_at_birth(const Contact& contact, std::span<const Contact> last,
                                  std::span<const Contact> now) const {
  constexpr double small = 1e-4;  // of the size
  const double overlap = -contact.at.gap;
  if (overlap <= small * contact_size(contact.candidate, contact.antagonist)) return 0;
  double known = 2 * reach_time_ * std::max(0.0, -relative_velocity(contact)[0]);
  for (const Contact& old : last)
    if (!has_same(now, old)) known = std::max(known, old.compression(old.at.gap));
  return overlap > known ? overlap - known : 0;
}

/// How deep a node of a deformable block may have sunk before a step found it [m]: no touch cuts a step.
template <int D>
double World<D>::sunk_by_step(const Contact& contact) const {
  const double travel = std::max(0.0, -relative_velocity(contact)[0]) * settings_.time_step;
  return std::min(travel, std::max(0.0, -contact.at.gap));
}

template <int D>
void World<D>::match_last() {
  const auto pair_of = [](const Contact& c) { return std::pair(c.candidate, c.antagonist); };
  const auto end_of_pair = [&](const std::vector<Contact>& list, std::size_t from) {
    std::size_t to = from;
    while (to < list.size() && pair_of(list[to]) == pair_of(list[from])) ++to;
    return to;
  };
  std::size_t from = 0;
  for (std::size_t a = 0; a < contacts_.size();) {
    const std::size_t end = end_of_pair(contacts_, a);
    while (from < last_.size() && pair_of(last_[from]) < pair_of(contacts_[a])) ++from;
    const bool met = from < last_.size() && pair_of(last_[from]) == pair_of(contacts_[a]);
    const std::span<const Contact> last(last_.data() + from, met ? end_of_pair(last_, from) - from : 0);
    const std::span<const Contact> now(contacts_.data() + a, end - a);
    for (; a < end; ++a) {
      Contact& contact = contacts_[a];
      const Contact* found = carried_on(contact, last, now);
      if (!found) {
        contact.born = overlap_at_birth(contact, last, now);
        if (deforms(contact)) contact.sunk = sunk_by_step(contact);
        continue;
      }
      contact.born = std::min(found->born, std::max(0.0, -contact.at.gap));
      if (found->carried) contact.impulse = found->impulse;
      contact.law = found->law;
      contact.mu_before = found->mu();
      contact.c_t_before = found->law.c_t;
      contact.history = found->history;
      contact.stretch = found->stretch;
      contact.sunk = std::min(found->sunk, std::max(0.0, -contact.at.gap));
      contact.age = found->age;
      contact.normal_force = found->normal_force;
      contact.slip_length = found->slip_length;
      contact.has_turned = found->has_turned;
      contact.carried = found->carried;
      contact.sticking = found->sticking;
    }
  }
}

/// The gap that a contact which should be closed may have because of the last solves of its bodies: their
/// residual times the time since then. The corners of a body that lands flat arrive with gaps of this size.
template <int D>
double World<D>::gap_of_solver(const Contact& contact) const {
  double gap = 0;
  for (const int body : {contact.candidate, contact.antagonist})
    if (body >= 0 && bodies[body].moves()) gap += unsolved_[body].residual * (time - unsolved_[body].since);
  return std::min(gap, carry_share * contact_size(contact.candidate, contact.antagonist));
}

/// Keeps the contacts that are closed now: those with a gap below touch plus a share of the size, and those
/// carried over from the last step. A node of a deformable block touches when its gap is not positive, apart
/// from rounding. One that was pushed is held while its gap is what the solver may have left of its speed:
/// without the force it would jump.
template <int D>
void World<D>::keep_closed(double share_of_size) {
  constexpr double rounding = 1e-14;  // m
  const auto gap_of_held_node = [&](const Contact& c) {
    if (!c.carried) return rounding;
    return c.impulse[0] > 0 ? carry_share * contact_size(c.candidate, c.antagonist)
                            : touch(c.candidate, c.antagonist);
  };
  std::erase_if(contacts_, [&](const Contact& c) {
    if (deforms(c)) return c.at.gap > gap_of_held_node(c);
    const double size = contact_size(c.candidate, c.antagonist);
    const double closed = 1e-12 + std::max((1e-9 + share_of_size) * size, gap_of_solver(c));
    return c.at.gap > (c.carried ? carry_reach(c.candidate, c.antagonist) : closed);
  });
  for (const Contact& c : contacts_)
    quality_.max_penetration = std::max(quality_.max_penetration, -c.at.gap - c.sunk);
}

/// The contactor of a body that has a feature, at a pose.
template <int D>
Placed<D> World<D>::placed(int body, FeatureId feature, const Pose& pose) const {
  return {bodies[body].contactor_with(feature), pose, contactor_of(feature)};
}

template <int D>
typename World<D>::Pose World<D>::pose_of(int body, bool at_start) const {
  return body < 0 ? Pose{} : at_start ? starts_[body].pose() : bodies[body].pose();
}

/// The gap between the features of a contact at poses of its bodies [m], by feature_gap (collision/pairs.h).
template <int D>
double World<D>::gap_at(const Contact& c, const Pose& of_candidate, const Pose& of_antagonist) const {
  const Placed<D> candidate = placed(c.candidate, c.at.feature, of_candidate);
  if (c.antagonist < 0)
    return feature_gap<D>(work_, candidate, c.at.feature, *terrain_, c.at.against, c.at.normal);
  return feature_gap<D>(work_, candidate, c.at.feature, placed(c.antagonist, c.at.against, of_antagonist),
                        c.at.against, c.at.normal);
}

/// The same now or at the start of the step [m]. What a held contact drifts is this at the start, less the
/// gap that is found in the middle.
template <int D>
double World<D>::gap_at(const Contact& c, bool at_start) const {
  // What the radii have changed of it since the start
  double swelled = 0;
  for (const int i : {c.candidate, c.antagonist})
    if (at_start && i >= 0 && bodies[i].breathes())
      swelled += bodies[i].breathing.side * (bodies[i].breathing.now.radius - starts_[i].shape.radius);
  return gap_at(c, pose_of(c.candidate, at_start), pose_of(c.antagonist, at_start)) - swelled;
}

template <int D>
typename World<D>::Overlap World<D>::deepest_overlap() {
  detect(0);
  return deepest_of_contacts();
}

/// Others have been looked at when they were added, so that a trial of n rocks costs n^2 distances, and no
/// more.
template <int D>
typename World<D>::Overlap World<D>::overlap_of_last() {
  const PhaseTimer timer(clock, &PhaseTimes::detect);
  contacts_.clear();
  const int last = static_cast<int>(bodies.size()) - 1;
  const Body<D>& own = bodies[last];
  if (own.moves()) find_between(last, -1, 0);
  for (int other = 0; other < last && bodies_meet(); ++other) {
    const double reach = bodies[other].size + own.size + reach_of_step(other, last);
    if ((bodies[other].x - own.x).norm() <= reach) find_between(other, last, 0);
  }
  return deepest_of_contacts();
}

template <int D>
typename World<D>::Overlap World<D>::deepest_of_contacts() {
  Overlap deepest;
  for (const Contact& c : contacts_) {
    if (-c.at.gap <= deepest.depth) continue;
    deepest = {-c.at.gap, c.candidate, c.antagonist};
    if (c.antagonist >= 0) std::swap(deepest.body, deepest.other);  // the candidate has the lower index
  }
  contacts_.clear();
  return deepest;
}

template <int D>
void World<D>::measure_penetration() {
  quality_.max_penetration = std::max(quality_.max_penetration, deepest_overlap().depth);
}

#define FLYROCK_INSTANTIATE(D)                                                                              \
  template double World<D>::contact_size(int, int) const;                                                   \
  template double World<D>::carry_reach(int, int) const;                                                    \
  template double World<D>::reach_within(double, int, int) const;                                           \
  template double World<D>::reach_in_middle(int, int) const;                                                \
  template const std::vector<std::pair<int, int>>& World<D>::near_pairs(double);                            \
  template void World<D>::find_contacts(double);                                                            \
  template void World<D>::find_points(int, int, const Geometry<D>::Pose&, const Geometry<D>::Pose&, double, \
                                      double);                                                              \
  template World<D>::Overlap World<D>::overlap_of_last();                                                   \
  template void World<D>::detect(double);                                                                   \
  template void World<D>::keep_closed(double);                                                              \
  template Placed<D> World<D>::placed(int, FeatureId, const Geometry<D>::Pose&) const;                      \
  template Geometry<D>::Pose World<D>::pose_of(int, bool) const;                                            \
  template double World<D>::gap_at(const Contact&, bool) const;                                             \
  template double World<D>::gap_at(const Contact&, const Geometry<D>::Pose&, const Geometry<D>::Pose&)      \
      const;                                                                                                \
  template World<D>::Overlap World<D>::deepest_overlap();                                                   \
  template void World<D>::measure_penetration()
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
