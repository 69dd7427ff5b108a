// Touches within a step of bodies that touch already.
//
// Two bodies are close in a step that solves a contact of theirs, and so are a body and the ground. No search
// runs between them: the end of the step shows what has come into what. Features that lie deeper in each
// other there than `slop`, and than what the step has solved, are an event: the step is cut where they
// touched. Balls, pills and hulls are searched on the ground, and on outlines, while they touch it, too.

#include <algorithm>

#include "world/manifold.h"
#include "world/same_contact.h"
#include "world/world.h"

namespace flyrock {

namespace {

Pose2 pose_at(const Motion2& m, double t) { return {m.position(t), Rotation2::from_angle(m.angle_at(t))}; }
Pose3 pose_at(const Motion3& m, double t) { return {m.position(t), m.turn(t).rotation}; }

/// Whether a contactor is searched on a ground, or an outline, that its body touches.
bool searches_held(Form form) { return form == Form::ball || form == Form::pill || form == Form::hull; }

}  // namespace

template <int D>
bool World<D>::is_close(int body, int other) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [&](const Contact& c) { return c.candidate == body && c.antagonist == other; });
}

template <int D>
bool World<D>::is_searched(int body, int contactor) const {
  return searches_held(bodies[body].contactors[contactor].form);
}

template <int D>
bool World<D>::is_searched(int body, int contactor, int other, int contactor_of_other) const {
  const Form a = bodies[body].contactors[contactor].form,
             b = bodies[other].contactors[contactor_of_other].form;
  return (b == Form::outline && searches_held(a)) || (a == Form::outline && searches_held(b));
}

/// How deep features lie in each other at time t of the step, deeper than a contact near them that it solves
/// along their normal [m].
template <int D>
double World<D>::unsolved_depth(int body, int other, double t) {
  constexpr double near = 0.1;  // of the size
  const Pose pose = pose_at(motions_[body], t), of_other = other < 0 ? pose : pose_at(motions_[other], t);
  find_points(body, other, pose, of_other, 0, t);
  double deepest = 0;
  for (const ContactPoint<D>& point : points_) {
    if (-point.gap <= deepest) continue;
    double solved = 0;
    for (const Contact& c : contacts_)
      if (c.candidate == body && c.antagonist == other && same_direction<D>(c.at.normal, point.normal) &&
          (c.at.point - point.point).norm() < near * contact_size(body, other))
        solved = std::max(solved, -gap_at(c, pose, of_other));
    deepest = std::max(deepest, -point.gap - solved);
  }
  return deepest;
}

/// Adds the features of a pair that lie in each other at the end of the step, and that it does not solve, to
/// the contacts that join it.
template <int D>
void World<D>::note_unsolved(int body, int other) {
  for (const ContactPoint<D>& point : points_) {
    Contact contact;
    contact.at = point;
    contact.candidate = body;
    contact.antagonist = other;
    if (!has_same(contacts_, contact) && !has_same(late_, contact)) late_.push_back(contact);
  }
}

/// When features of a close pair first touch that the step does not solve [s], if its end shows them deeper
/// in each other than `slop`. Those that close no faster than `rest_speed` join the contacts of the step
/// instead.
template <int D>
std::optional<double> World<D>::first_event(int body, int other, double h) {
  constexpr double soonest = 1e-3, accuracy = 1e-9;  // of the step
  const double depth = unsolved_depth(body, other, h);
  if (depth <= slop * contact_size(body, other)) return std::nullopt;
  const double touches = touch(body, other);
  double low = soonest * h, high = h;
  if (unsolved_depth(body, other, low) > touches) high = low;
  while (high - low > accuracy * h) {
    const double middle = 0.5 * (low + high);
    (unsolved_depth(body, other, middle) > touches ? high : low) = middle;
  }
  if (depth <= settings_.rest_speed * (h - low)) {
    const std::size_t known = late_.size();
    unsolved_depth(body, other, h);
    note_unsolved(body, other);
    if (late_.size() > known) return std::nullopt;
  }
  return low;
}

/// Measures how deep features of close pairs lie in each other at the end of a step that is not cut again.
template <int D>
void World<D>::measure_unsolved(double h) {
  find_motions(h);
  for (const Contact& c : contacts_) {
    const double share =
        unsolved_depth(c.candidate, c.antagonist, h) / contact_size(c.candidate, c.antagonist);
    if (share > slop) quality_.unsolved_depth = std::max(quality_.unsolved_depth, share);
  }
}

#define FLYROCK_INSTANTIATE(D)                                            \
  template bool World<D>::is_close(int, int) const;                       \
  template bool World<D>::is_searched(int, int) const;                    \
  template bool World<D>::is_searched(int, int, int, int) const;          \
  template std::optional<double> World<D>::first_event(int, int, double); \
  template void World<D>::measure_unsolved(double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
