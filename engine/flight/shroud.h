#pragma once
// How far and how high launches of one speed reach, over all angles.

#include "flight/ballistic.h"

namespace flyrock {

/// The range [m] of a launch over level ground `height` [m] below it. The gravity of `forces` must act along
/// -y. A flight ends after `longest` [s].
double level_range(const Forces<2>& forces, const Vec2& velocity, double height, double longest);

/// The elevation [rad] in (0, pi/2) with the greatest range over level ground `height` [m] below the launch,
/// to 1e-4 rad, and this range [m]. The gravity of `forces` must act along -y. A flight ends after `longest`
/// [s].
struct Farthest {
  double elevation = 0, range = 0;
};
Farthest farthest(const Forces<2>& forces, double speed, double height, double longest);

/// The envelope of all launches of one speed without air [m above the launch] at the horizontal distance x:
///   v^2/(2 g) - g x^2/(2 v^2). No flight reaches higher there.
double vacuum_envelope(double speed, double x, double gravity);

/// The envelope (shroud) of the launches of one speed from the origin, upwards and towards +x. Returns
/// `points` points at equal distances x from 0 to the greatest range, with the greatest height [m] at each x,
/// down to level ground `height` below. Without air it is vacuum_envelope. In air it is the maximum
/// over a fan of 180 flights, denser for steep angles; its error is less than 1e-3 of the range. Flights end
/// after `longest` [s]. A speed of 0 gives no points.
std::vector<Vec2> shroud(const Forces<2>& forces, double speed, double height, double longest, int points);

}  // namespace flyrock
