#pragma once
// Random placements of a contactor near its opponent, and random motions from there.

#include <algorithm>
#include <stdexcept>

#include "bench/pair_questions.h"
#include "placed_shapes.h"

namespace flyrock {

/// In metres, seconds and radians. The gap is drawn between `least_gap` and `greatest_gap`. Half of the
/// motions begin with an approach, so that about half of the searches for the time of impact find one.
struct NearTouch {
  static constexpr double least_gap = 0.1e-3, greatest_gap = 0.9e-3, reach = 1e-3;
  static constexpr double normal_speed = 1, other_speed = 2, spin = 5, duration = 5e-3;
};

/// Moves the contactor along the normal of its deepest contact until this contact has the gap. Returns
/// whether that succeeds. It fails if two polytopes look past each other, because they have no contact then.
template <int D, class Opponent>
bool bring_to_gap(const typename Geometry<D>::Contactor& contactor, const Opponent& opponent, double gap,
                  Placement<D>& placement) {
  constexpr double far = 10, exact = 1e-9;  // m
  constexpr int tries = 20;                 // the deepest contact changes while the contactor moves
  std::vector<ContactPoint<D>> contacts;
  for (int i = 0; i < tries; ++i) {
    contacts.clear();
    opponent.contacts(contactor, placement, far, contacts);
    if (contacts.empty()) return false;
    placement.contact = *std::min_element(contacts.begin(), contacts.end(),
                                          [](const auto& p, const auto& q) { return p.gap < q.gap; });
    const double missing = gap - placement.contact.gap;
    if (std::abs(missing) < exact) return true;
    placement.pose.x += missing * placement.contact.normal;
  }
  return false;
}

/// A motion from a pose with the velocity v, the acceleration a and a spin that is drawn.
inline Motion2 motion_from(const Pose2& pose, const Vec2& v, const Vec2& a, double greatest_spin,
                           Dice& dice) {
  Motion2 motion{{pose.x, v, a}};
  motion.angle = std::atan2(pose.r.s, pose.r.c);
  motion.w = dice(-greatest_spin, greatest_spin);
  return motion;
}

/// In 3D the spin vector is constant, as it nearly is in a step with contacts.
inline Motion3 motion_from(const Pose3& pose, const Vec3& v, const Vec3& a, double greatest_spin,
                           Dice& dice) {
  const Vec3 spin = dice(0, greatest_spin) * dice.direction<3>();
  return {{pose.x, v, a}, GivenRotation{.start = pose.r, .w = spin, .alpha = Vec3::Zero()}};
}

/// Draws how the two move. The opponent only spins, and a room is at rest.
template <int D, class Opponent>
void draw_motions(const Opponent& opponent, Placement<D>& placement, Dice& dice) {
  const double opening = dice(-NearTouch::normal_speed, NearTouch::normal_speed);
  const Vec<D> other = dice(0, NearTouch::other_speed) * dice.direction<D>();
  const Vec<D> v = opening * placement.contact.normal + other;
  const Vec<D> gravity = -9.81 * Vec<D>::Unit(D - 1), zero = Vec<D>::Zero();
  const double spin_of_opponent = opponent.is_hollow() ? 0 : NearTouch::spin;
  placement.motion = motion_from(placement.pose, v, gravity, NearTouch::spin, dice);
  placement.motion_of_opponent = motion_from(placement.pose_of_opponent, zero, zero, spin_of_opponent, dice);
}

/// Each pair has its own placements, and they are the same in each run.
template <int D, class Opponent>
std::vector<Placement<D>> near_touch_placements(const typename Geometry<D>::Contactor& contactor,
                                                const Opponent& opponent, int count) {
  Dice dice;
  std::vector<Placement<D>> placements;
  for (int tries = 0; static_cast<int>(placements.size()) < count; ++tries) {
    if (tries == 100 * count) throw std::runtime_error("no placements near touch for a pair of shapes");
    const double distance = opponent.is_hollow() ? dice(0.1, 0.5) : dice(0.3, 1.6);
    Placement<D> placement;
    placement.pose = {distance * dice.direction<D>(), dice.flush_rotation<D>()};
    placement.pose_of_opponent = {Vec<D>::Zero(), dice.flush_rotation<D>()};
    const double gap = dice(NearTouch::least_gap, NearTouch::greatest_gap);
    if (!bring_to_gap<D>(contactor, opponent, gap, placement)) continue;
    draw_motions<D>(opponent, placement, dice);
    placements.push_back(placement);
  }
  return placements;
}

}  // namespace flyrock
