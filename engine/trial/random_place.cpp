#include "trial/random_place.h"

#include <algorithm>

namespace flyrock {

Vec3 random_along(const std::vector<Vec3>& points, RandomStream& rng) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  double left = rng.uniform() * length;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double part = (points[i] - points[i - 1]).norm();
    if (left <= part || i + 1 == points.size())
      return points[i - 1] + std::min(1.0, left / part) * (points[i] - points[i - 1]);
    left -= part;
  }
  return points.front();
}

/// A uniform place in a flat convex polygon: first a triangle of its fan, chosen by area, then a point in it.
Vec3 random_inside(const std::vector<Vec3>& points, RandomStream& rng) {
  const auto area = [&](std::size_t i) {
    return (points[i] - points[0]).cross(points[i + 1] - points[0]).norm();
  };
  double total = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) total += area(i);
  double left = rng.uniform() * total;
  std::size_t triangle = 1;
  while (triangle + 2 < points.size() && left > area(triangle)) left -= area(triangle++);
  double u = rng.uniform(), v = rng.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return points[0] + u * (points[triangle] - points[0]) + v * (points[triangle + 1] - points[0]);
}

}  // namespace flyrock
