#pragma once
// The area inside of a closed line of points.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// Twice the area, positive where the points go round counter-clockwise.
inline double doubled_area(const std::vector<Vec2>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += cross(Vec2(points[i] - points[0]), Vec2(points[(i + 1) % points.size()] - points[0]));
  return sum;
}

}  // namespace flyrock
