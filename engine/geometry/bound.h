#pragma once
// How far a contactor extends from the origin of its frame.

#include <algorithm>
#include <cmath>
#include <vector>

namespace flyrock {

/// The radius [m] of the smallest circle or sphere about the origin that contains `points`, plus `radius`.
template <class Point>
double bound_of(const std::vector<Point>& points, double radius) {
  double farthest = 0;  // squared
  for (const Point& point : points) farthest = std::max(farthest, point.squaredNorm());
  return std::sqrt(farthest) + radius;
}

}  // namespace flyrock
