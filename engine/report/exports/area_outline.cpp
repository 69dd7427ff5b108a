#include "report/exports/area_outline.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// 0 inside of the hull.
double distance_from_hull(const std::vector<Vec2>& hull, const Vec2& place) {
  double least = infinite;
  bool inside = hull.size() > 2;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 edge = hull[(i + 1) % hull.size()] - hull[i], from = place - hull[i];
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0 ? std::clamp(from.dot(edge) / length2, 0.0, 1.0) : 0;
    least = std::min(least, (from - share * edge).norm());
    inside = inside && cross(edge, from) >= 0;
  }
  return inside ? 0 : least;
}

/// Where the ray from the centre is at a distance from the hull. Along a ray that begins in a convex hull,
/// the distance grows.
Vec2 place_on_ray(const Vec2& centre, const std::vector<Vec2>& hull, double angle, double distance) {
  const Vec2 direction(std::cos(angle), std::sin(angle));
  double near = 0, far = distance;
  for (const Vec2& corner : hull) far = std::max(far, distance + (corner - centre).norm());
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (near + far);
    (distance_from_hull(hull, centre + middle * direction) <= distance ? near : far) = middle;
  }
  return centre + near * direction;
}

}  // namespace

PlanRing area_outline(const Vec2& centre, const std::vector<Vec2>& hull,
                      const std::vector<AreaSector>& sectors) {
  PlanRing ring;
  if (sectors.empty()) return ring;
  const double half = pi / static_cast<double>(sectors.size());
  const int pieces = std::max(4, static_cast<int>(std::ceil(half * 180 / pi)));
  for (const AreaSector& sector : sectors)
    for (int i = 0; i <= pieces; ++i) {
      const Vec2 place =
          place_on_ray(centre, hull, sector.azimuth + half * (2.0 * i / pieces - 1), sector.distance);
      if (ring.empty() || (place - ring.back()).norm() > 1e-9) ring.push_back(place);
    }
  if (ring.size() > 1 && (ring.front() - ring.back()).norm() <= 1e-9) ring.pop_back();
  return ring;
}

}  // namespace flyrock
