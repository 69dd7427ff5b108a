#pragma once
// How far a contactor reaches from its frame's origin.

#include <algorithm>
#include <cmath>
#include <vector>

namespace flyrock {

/// Radius of the smallest circle or sphere about the origin that holds `points`, grown by `radius`.
template <class Point>
double bound_of(const std::vector<Point>& points, double radius) {
  double farthest = 0;  // squared
  for (const Point& point : points) farthest = std::max(farthest, point.squaredNorm());
  return std::sqrt(farthest) + radius;
}

}  // namespace flyrock
