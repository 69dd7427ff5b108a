#include "flight/vacuum.h"

#include <cmath>

namespace flyrock {

double vacuum_range(double speed, double elevation, double height, double gravity) {
  const double up = speed * std::sin(elevation);
  return speed * std::cos(elevation) * (up + std::sqrt(up * up + 2 * gravity * height)) / gravity;
}

double best_vacuum_elevation(double speed, double height, double gravity) {
  return std::atan2(speed, std::sqrt(speed * speed + 2 * gravity * height));
}

double greatest_vacuum_range(double speed, double height, double gravity) {
  return speed / gravity * std::sqrt(speed * speed + 2 * gravity * height);
}

double vacuum_envelope(double speed, double x, double gravity) {
  const double squared = speed * speed;
  return squared / (2 * gravity) - gravity * x * x / (2 * squared);
}

}  // namespace flyrock
