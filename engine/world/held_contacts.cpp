// Which contacts a step solves, and what the search for touches knows of them (collision/held.h).

#include <algorithm>

#include "collision/pairs.h"
#include "collision/safe_time.h"
#include "world/manifold.h"
#include "world/same_contact.h"
#include "world/world.h"

namespace flyrock {

namespace {

// Of the size: a contact that the last impact opened, and that is nearer, would be found as a touch at once.
constexpr double apart_share = 1e-8;

// Of the size: a contact with a greater gap or overlap is looked at again within the step.
constexpr double step_share = 2e-5;

/// Whether a contactor is a point at the centre of mass.
template <class Contactor>
bool is_point(const Contactor& shape) {
  return shape.form == Form::ball && shape.radius == 0 && shape.points[0].isZero();
}

/// A contact as a search knows it.
template <int D>
HeldContact held_contact(const WorldContact<D>& c) {
  HeldContact held{c.at.feature, c.at.against};
  if constexpr (D == 3) held.normal = c.at.normal;
  return held;
}

}  // namespace

/// Keeps the contacts, detected in the middle of a step, that enter its problem, and measures their drift.
/// Springs are left out of its share, because they penetrate by design; so are late contacts, which arrive.
template <int D>
typename World<D>::Drift World<D>::keep_closed_at_start(double h) {
  constexpr double most_drift = 5e-5;  // of the size
  Drift drift;
  std::erase_if(contacts_, [&](Contact& c) {
    const double gap = gap_at(c, true);
    if (!enters_step(c, gap, h)) return true;
    if (c.late) return false;
    // On the next segment of the terrain, the gap at the start is measured to the line beyond the end of the
    // segment. The larger of the two gaps is therefore the true one.
    drift.penetration = std::max(drift.penetration, -std::max(gap, c.at.gap));
    if (c.law.condition == NormalCondition::penalty) return false;
    // A chosen step may be so long that the drift of bodies on others would be seen as overlap.
    double most = may_drift(c);
    if (chooses_steps() && c.antagonist >= 0)
      most = std::min(most, most_drift * contact_size(c.candidate, c.antagonist));
    drift.share = std::max(drift.share, (std::min(gap, 0.0) - c.at.gap) / most);
    return false;
  });
  return drift;
}

/// How far a held contact may drift in one step [m].
template <int D>
double World<D>::may_drift(const Contact& c) const {
  return 3 * reach_in_middle(c.candidate, c.antagonist);
}

/// Whether a contact that is detected in the middle of a step enters its problem. `gap` [m]: of its features
/// at the start. It does if they were closed there; those that join it late are told as `late`. A contact
/// that closed since then is a touch at which the step must be cut. A contact whose features have changed,
/// but not its position, was closed. A new feature pair that starts deeper than one step can push it was not
/// touching before, unless a search at the start finds the depth, too: it does not enter. A contact that is
/// carried on by its neighbour, as a vertex that slides from one side of a valley to the other, touches where
/// it closes by more than drift would.
template <int D>
bool World<D>::enters_step(Contact& c, double gap, double h) {
  c.late = has_same(late_, c) || settles(c, gap, h);
  if (c.late) return true;
  const double size = contact_size(c.candidate, c.antagonist);
  const double closed_alone = touch(c.candidate, c.antagonist);
  // One that the last impact opened may close again at once; the search for touches takes it for closed.
  const bool is_near = gap > closed_alone && gap <= apart_share * size;
  const double closed =
      c.carried || (is_near && has_same(last_, c)) ? carry_reach(c.candidate, c.antagonist) : closed_alone;
  if (c.at.gap > reach_in_middle(c.candidate, c.antagonist) || gap > closed) return false;
  if (!c.carried && gap < -may_drift(c) && !is_deep(c, gap, true)) return false;
  // One that the last impact opened and that is apart in the middle is held if it will come back so slowly
  // that it stays; else it is left to first_touch, and collides where it returns.
  const bool yields = c.law.condition == NormalCondition::penalty;
  const bool is_apart = c.at.gap > std::max(gap, 0.0) + step_share * size;
  if (!yields && is_apart && opened(c) > settings_.rest_speed) return false;
  return !c.carried || has_same(last_, c) || gap <= closed_alone ||
         gap - c.at.gap <= 3 * reach_within(h, c.candidate, c.antagonist);
}

/// Whether places of two close bodies that are within `slop` of each other at the start of the step come
/// together within it, so slowly that they do not collide.
template <int D>
bool World<D>::settles(const Contact& c, double gap, double h) const {
  if (c.antagonist < 0 || c.carried || c.law.condition == NormalCondition::penalty) return false;
  const double closes = gap - c.at.gap, size = contact_size(c.candidate, c.antagonist);
  return gap >= 0 && gap <= slop * size && closes > 0 &&
         closes <= settings_.rest_speed * (1 - settings_.theta) * h;
}

/// How fast the last impact or step has opened a contact [m/s]; 0 if it did not.
template <int D>
double World<D>::opened(const Contact& contact) const {
  for (std::size_t a = 0; a < last_.size(); ++a)
    if (is_same(last_[a], contact)) return last_[a].carried ? 0.0 : std::max(0.0, last_after_[a][0]);
  return 0;
}

/// Whether the contactors of a contact lie in each other now, or lay so at the start of the step, about as
/// deep as the gap of its features says. The features alone may be beside each other.
template <int D>
bool World<D>::is_deep(const Contact& c, double gap, bool at_start) {
  const Placed<D> candidate = placed(c.candidate, c.at.feature, pose_of(c.candidate, at_start));
  points_.clear();
  if (c.antagonist < 0)
    terrain_contacts<D>(work_, candidate, *terrain_, 0, 0, points_);
  else
    body_contacts(work_, candidate, placed(c.antagonist, c.at.against, pose_of(c.antagonist, at_start)), 0,
                  points_);
  return std::any_of(points_.begin(), points_.end(), [&](const ContactPoint<D>& p) {
    return p.gap < 0.5 * gap && same_direction<D>(p.normal, c.at.normal);
  });
}

/// Those of the last step or impact: in flight, they count as opened.
template <int D>
HeldContacts World<D>::held_in_flight(int body, int other) {
  held_.clear();
  for (const auto* list : {&contacts_, &last_})
    for (const Contact& c : *list)
      if (c.candidate == body && c.antagonist == other) held_.push_back(held_contact(c));
  return {held_, false};
}

/// Contacts of a body with the ground, or with an outline: those that the step from starts_ solves, and those
/// of the last step or impact that it does not solve, as long as their gap at the start is at most 1e-8 of
/// the size: a search would take them for touches at once. Left out is a mass point that leaves the ground:
/// from one side of a valley along the other, it is at once beside the strip of the side that it leaves.
template <int D>
HeldContacts World<D>::held_in_step(int body, int other) {
  constexpr double opening = 1e-8;  // m/s, above rounding
  held_.clear();
  for (const Contact& c : contacts_)
    if (c.candidate == body && c.antagonist == other) held_.push_back(held_contact(c));
  for (const Contact& c : last_) {
    if (c.candidate != body || c.antagonist != other || has_same(contacts_, c)) continue;
    const bool leaves = other < 0 && is_point(bodies[body].contactor_with(c.at.feature)) &&
                        starts_[body].v.dot(c.at.normal) > opening;
    if (gap_at(c, true) <= apart_share * contact_size(body, other) && !leaves)
      held_.push_back(held_contact(c));
  }
  return {held_, true};
}

/// How deep the springs of a pair lie in each other at the start or end of the step [m].
template <int D>
double World<D>::sunk_springs(int body, int other) {
  double sunk = 0;
  for (const Contact& c : contacts_)
    if (c.candidate == body && c.antagonist == other && c.law.condition == NormalCondition::penalty)
      sunk = std::max({sunk, -gap_at(c, true), -gap_at(c, false)});
  return sunk;
}

/// When the first contact of the last step with a ground that this one does not solve has closed again [s]:
/// it opened, other contacts have turned its body back, and the search for touches may have passed over it.
/// Its gap is taken for a parabola.
template <int D>
std::optional<double> World<D>::first_return(double h) {
  constexpr double soon = 1e-3;  // of the step
  std::optional<double> first;
  for (std::size_t a = 0; a < last_.size(); ++a) {
    const Contact& c = last_[a];
    const int part = contactor_of(c.at.feature);
    const bool searched = c.antagonist < 0
                              ? is_searched(c.candidate, part) || !is_close(c.candidate, -1)
                              : is_searched(c.candidate, part, c.antagonist, contactor_of(c.at.against));
    if (!searched || c.law.condition == NormalCondition::penalty || has_same(contacts_, c)) continue;
    const double end = gap_at(c, false);
    const double sunk = opened(c) > settings_.rest_speed
                            ? touch(c.candidate, c.antagonist)
                            : step_share * contact_size(c.candidate, c.antagonist);
    if (end > -sunk || !is_deep(c, end, false)) continue;
    const double start = std::max(gap_at(c, true), 0.0);
    const double opens = h * std::max(last_after_[a][0], 0.0);
    const double returns = h * std::max(soon, (start + opens) / (start + opens - end));
    if (!first || returns < *first) first = returns;
  }
  return first;
}

#define FLYROCK_INSTANTIATE(D)                                     \
  template World<D>::Drift World<D>::keep_closed_at_start(double); \
  template std::optional<double> World<D>::first_return(double);   \
  template HeldContacts World<D>::held_in_flight(int, int);        \
  template HeldContacts World<D>::held_in_step(int, int);          \
  template double World<D>::sunk_springs(int, int)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
