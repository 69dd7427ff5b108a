#pragma once
// When a point in uniformly accelerated motion along an axis is at a place.

#include <array>
#include <cmath>
#include <limits>

namespace flyrock {

/// The first and the second time [s] at which a point is at a place that lies `ahead` of it [m], when it
/// starts with the velocity `speed` [m/s] and has the acceleration `push` [m/s2]: the roots t >= 0 of ahead =
/// speed t + push t^2 / 2, in the form that does not subtract. Infinity if there is none. A point at the
/// place or (by rounding) beyond it is there at 0.
inline std::array<double, 2> travel_times(double ahead, double speed, double push) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (ahead <= 0) return {0, speed * push < 0 ? -2 * speed / push : never};
  const double discriminant = speed * speed + 2 * push * ahead;
  if (ahead == never || discriminant < 0) return {never, never};
  const double arrival_speed = std::sqrt(discriminant);
  double first = never;
  if (speed < 0)
    first = push > 0 ? (arrival_speed - speed) / push : never;
  else if (speed + arrival_speed > 0)
    first = 2 * ahead / (speed + arrival_speed);
  return {first, push < 0 ? first - 2 * arrival_speed / push : never};
}

}  // namespace flyrock
