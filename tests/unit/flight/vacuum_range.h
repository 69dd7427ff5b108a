#pragma once
// Ranges of flights without air in closed form, over level ground, from a height h [m] above it, with gravity
// g [m/s2].
//
// Source: the parabola; J. Roth, A model for the determination of flyrock range, USBM J0387242 (1979), gives
// the range from a height for 45 degrees only, which is not the greatest range.

#include <cmath>

namespace flyrock {

/// The horizontal distance [m] at which a launch at `speed` [m/s] and `elevation` [rad] reaches the ground:
///   v cos(e) (v sin(e) + sqrt(v^2 sin^2(e) + 2 g h)) / g.
inline double vacuum_range(double speed, double elevation, double height, double gravity) {
  const double up = speed * std::sin(elevation);
  return speed * std::cos(elevation) * (up + std::sqrt(up * up + 2 * gravity * height)) / gravity;
}

/// The elevation [rad] with the greatest range, tan e = v / sqrt(v^2 + 2 g h), and this range [m], (v/g)
/// sqrt(v^2 + 2 g h).
inline double best_vacuum_elevation(double speed, double height, double gravity) {
  return std::atan2(speed, std::sqrt(speed * speed + 2 * gravity * height));
}
inline double greatest_vacuum_range(double speed, double height, double gravity) {
  return speed / gravity * std::sqrt(speed * speed + 2 * gravity * height);
}

}  // namespace flyrock
