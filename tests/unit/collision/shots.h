#pragma once
// Shapes that are shot at others, and whether a time of impact agrees with the gaps before and at it.

#include <cmath>
#include <optional>

#include "collision/geometry.h"
#include "dice.h"

namespace flyrock {

/// Up to 300 m/s, towards the origin from 1.5 to 4 m.
template <int D>
typename Geometry<D>::Motion flight_to_origin(Dice& dice) {
  typename Geometry<D>::Motion motion;
  motion.x = dice(1.5, 4) * dice.direction<D>();
  motion.v = dice(0, 300) * (dice(0, 0.8) * dice.direction<D>() - motion.x).normalized();
  motion.a = -9.81 * Vec<D>::Unit(D - 1);
  return motion;
}
/// The same with a spin of up to 500 rad/s.
inline Motion2 shot(Dice& dice) {
  Motion2 motion = flight_to_origin<2>(dice);
  motion.angle = dice(-pi, pi);
  motion.w = dice(-500, 500);
  return motion;
}
inline Motion3 shot(Dice& dice, const Vec3& moments, Rotation3 (Dice::*attitude)() = &Dice::rotation<3>) {
  Motion3 motion = flight_to_origin<3>(dice);
  motion.rotation = FreeRotation(moments, (dice.*attitude)(), dice(0, 500) * dice.direction<3>());
  return motion;
}

inline Placed2 at(const Contactor2& shape, const Motion2& motion, double t) {
  return {shape, {motion.position(t), Rotation2::from_angle(motion.angle_at(t))}};
}
inline Placed3 at(const Contactor3& shape, const Motion3& motion, double t) {
  return {shape, {motion.position(t), motion.turn(t).rotation}};
}

/// Whether a gap is open within `before` [m] until a time of impact, or until `end`, and closed within
/// `at_touch` [m] at it.
template <class Gap>
bool agrees(const std::optional<double>& touch, double end, double before, double at_touch, const Gap& gap) {
  constexpr int times = 100;
  for (int i = 0; i < times; ++i)
    if (gap(touch.value_or(end) * i / times) < -before) return false;
  return !touch || std::abs(gap(*touch)) < at_touch;
}

}  // namespace flyrock
