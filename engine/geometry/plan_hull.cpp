#include "geometry/plan_hull.h"

#include <algorithm>

#include "geometry/box.h"

namespace flyrock {

namespace {

/// Adds the lower chain (points from left to right) or the upper chain (from right to left) to `hull`,
/// without its last point.
template <class Iterator>
void add_chain(Iterator begin, Iterator end, std::vector<Vec2>& hull) {
  const std::size_t first = hull.size();
  for (Iterator point = begin; point != end; ++point) {
    while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(*point);
  }
  hull.pop_back();
}

double distance_from_side(const Vec2& a, const Vec2& b, const Vec2& place) {
  const Vec2 side = b - a;
  const double length2 = side.squaredNorm();
  const double along = length2 > 0 ? std::clamp((place - a).dot(side) / length2, 0.0, 1.0) : 0;
  return (place - (a + along * side)).norm();
}

}  // namespace

std::vector<Vec2> plan_hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  add_chain(points.begin(), points.end(), hull);
  add_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

Vec2 centroid_of(const std::vector<Vec2>& hull) {
  if (hull.empty()) return Vec2::Zero();
  Vec2 moment = Vec2::Zero();
  double area2 = 0;  // twice the area
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 a = hull[i] - hull[0], b = hull[(i + 1) % hull.size()] - hull[0];
    area2 += cross(a, b);
    moment += cross(a, b) * (a + b) / 3;
  }
  const Box2 box = Box2::around(hull);
  constexpr double thin = 1e-9;  // area / length^2, below which the hull is a line up to rounding
  if (area2 <= thin * box.size().squaredNorm()) return 0.5 * (box.low + box.high);
  return hull[0] + moment / area2;
}

double distance_from(const std::vector<Vec2>& hull, const Vec2& place) {
  double least = infinite;
  bool inside = hull.size() > 2;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    least = std::min(least, distance_from_side(a, b, place));
    inside = inside && cross(b - a, place - a) >= 0;
  }
  return inside ? 0 : least;
}

}  // namespace flyrock
