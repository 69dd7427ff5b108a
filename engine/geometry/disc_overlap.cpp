#include "geometry/disc_overlap.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

double sector(const Vec2& a, const Vec2& b, double radius) {
  return 0.5 * radius * radius * std::atan2(cross(a, b), a.dot(b));
}

/// The signed area of the triangle (0, a, b) inside the disc about 0.
double triangle_overlap(const Vec2& a, const Vec2& b, double radius) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0) return 0;
  // |a + s along| = radius
  const double middle = -a.dot(along) / length2;
  const double inside = middle * middle - (a.squaredNorm() - radius * radius) / length2;
  if (inside <= 0) return sector(a, b, radius);
  const double half = std::sqrt(inside);
  const double from = std::clamp(middle - half, 0.0, 1.0), to = std::clamp(middle + half, 0.0, 1.0);
  if (from >= to) return sector(a, b, radius);
  const Vec2 enters = a + from * along, leaves = a + to * along;
  return sector(a, enters, radius) + 0.5 * cross(enters, leaves) + sector(leaves, b, radius);
}

}  // namespace

double disc_overlap(const std::vector<Vec2>& polygon, const Vec2& centre, double radius) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += triangle_overlap(polygon[i] - centre, polygon[(i + 1) % polygon.size()] - centre, radius);
  return area;
}

}  // namespace flyrock
