#include "world/air.h"

#include <algorithm>
#include <cmath>

#include "math/sphere.h"

namespace flyrock {

double drag_constant(double density, double cd, double mass, double volume) {
  const double radius = sphere_radius(volume);
  return density * cd * pi * radius * radius / (2 * mass);
}

template <int D>
std::array<Vec<D>, 2> leg_accelerations(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity,
                                        double h) {
  const Vec<D> a1 = air.acceleration(velocity);
  const Vec<D> a2 = air.acceleration(velocity + 0.5 * h * (gravity + a1));
  const Vec<D> a3 = air.acceleration(velocity + 0.5 * h * (gravity + a2));
  const Vec<D> a4 = air.acceleration(velocity + h * (gravity + a3));
  const Vec<D> middle = 2 * (a2 + a3);
  return {(3 * a1 + middle - a4) / 6, (middle - a1 + 3 * a4) / 6};
}

template <int D>
double leg_length(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity) {
  constexpr double longest = 0.1;
  // |a'| <= 2 k |v - w| |dv/dt|, where the speed includes what gravity can add during the leg.
  const double speed = (velocity - air.wind).norm() + longest * gravity.norm();
  const double rate = 2 * air.drag * speed, change = rate * (air.drag * speed * speed + gravity.norm());
  if (!(change > 0)) return longest;
  constexpr double stable =
      0.5;  // share of the time in which drag stops a rock; the scheme loses its order above it
  return std::min({longest, std::cbrt(324 * leg_tolerance / change), stable / rate});
}

template std::array<Vec<2>, 2> leg_accelerations(const Air<2>&, const Vec<2>&, const Vec<2>&, double);
template std::array<Vec<3>, 2> leg_accelerations(const Air<3>&, const Vec<3>&, const Vec<3>&, double);
template double leg_length(const Air<2>&, const Vec<2>&, const Vec<2>&);
template double leg_length(const Air<3>&, const Vec<3>&, const Vec<3>&);

}  // namespace flyrock
