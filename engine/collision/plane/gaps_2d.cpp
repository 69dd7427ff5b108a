// Gaps of known features of balls, pills and hulls in 2D.
#include "collision/rules.h"

namespace flyrock {

namespace {
bool is_edge(FeatureId feature) { return feature & 1; }

/// The distance of p from the two segments at a convex corner. A disk that has rolled past the corner is over
/// one of them.
double from_corner(const Vec2& p, const Ground2& ground, int corner) {
  const Vec2 away = p - ground.point(corner);
  if (away.dot(ground.tangent(corner)) > 0) return away.dot(ground.normal(corner));
  if (away.dot(ground.tangent(corner - 1)) < 0) return away.dot(ground.normal(corner - 1));
  return away.norm();
}
}  // namespace

double hull_gap_to_ground(Workspace&, const Placed2& contactor, FeatureId feature, const Ground2& ground,
                          FeatureId against, const Vec2&) {
  const int i = terrain_index(against), k = index_2d(feature);
  if (is_edge(feature)) return contactor.outside(k, ground.point(i)) - contactor.shape.radius;
  const Vec2 p = contactor.point(k);
  const double distance =
      is_corner(against) ? from_corner(p, ground, i) : (p - ground.start(i)).dot(ground.normal(i));
  return distance - contactor.shape.radius;
}

double core_gap(Workspace&, const Placed2& candidate, FeatureId feature, const Placed2& antagonist,
                FeatureId against, const Vec2&) {
  const int k = index_2d(feature), j = index_2d(against);
  const double radii = candidate.shape.radius + antagonist.shape.radius;
  if (is_edge(feature)) return candidate.outside(k, antagonist.point(j)) - radii;
  if (is_edge(against)) return antagonist.outside(j, candidate.point(k)) - radii;
  return (candidate.point(k) - antagonist.point(j)).norm() - radii;
}

}  // namespace flyrock
