#pragma once
// How far and how high all launches of one speed reach, whatever their angle.

#include "flight/ballistic.h"

namespace flyrock {

/// How far a launch goes over level ground `height` [m] below it; `forces` with gravity along -y. A flight
/// that lasts longer than `longest` [s] ends then.
double level_range(const Forces<2>& forces, const Vec2& velocity, double height, double longest);

/// The elevation [rad] in (0, pi/2) that goes farthest over level ground `height` [m] below the launch, to
/// 1e-4 rad, and its distance [m]. `forces` with gravity along -y. A flight that lasts longer than `longest`
/// [s] ends then.
struct Farthest {
  double elevation = 0, range = 0;
};
Farthest farthest(const Forces<2>& forces, double speed, double height, double longest);

/// The envelope (shroud) of the launches of one speed from the origin, upwards and towards +x: `points`
/// places, at equal distances x from 0 to the farthest, and the greatest height [m] there, down to level
/// ground `height` below. Without air it is v^2/(2 g) - g x^2/(2 v^2); in air the greatest of a fan of 180
/// flights, the denser the steeper, by which it is out by less than 1e-3 of the range. Flights end after
/// `longest` [s]. No speed, no points.
std::vector<Vec2> shroud(const Forces<2>& forces, double speed, double height, double longest, int points);

}  // namespace flyrock
