#include "collision/terrain_contact.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

using Contacts = std::vector<ContactPoint<2>>;

// A vertex that is less deep than this share of the size touches each segment that it lies below. A deeper
// vertex, which only fixed time steps produce, is pushed out to the nearest point.
constexpr double shallow_share = 1e-3;

bool in_cone(const Terrain2& terrain, int corner, const Vec2& direction, double slack) {
  return direction.dot(terrain.tangent(corner - 1)) >= -slack &&
         direction.dot(terrain.tangent(corner)) <= slack;
}

/// Whether the strip of the segment contains p. At a flat or convex corner only the right segment owns the
/// point. At a concave corner both segments own it, and the strip is longer by `shallow`, because the point
/// may have sunk into the other segment.
bool owns(const Terrain2& terrain, int segment, const Vec2& p, double shallow) {
  const double length = terrain.length(segment), slack = 1e-9 * length;
  const double s = (p - terrain.start(segment)).dot(terrain.tangent(segment));
  const int next = segment + 1;
  const bool concave_start = terrain.corner(segment) == Corner::concave,
             concave_end = terrain.corner(next) == Corner::concave;
  if (s < -(concave_start ? shallow : slack) || s > length + (concave_end ? shallow : slack)) return false;
  if (s <= length - slack || next >= terrain.segments() || concave_end) return true;
  return (p - terrain.start(next)).dot(terrain.tangent(next)) < -slack;
}

/// The point of the polyline that is nearest to a point in the ground.
ContactPoint<2> nearest_place(const Terrain2& terrain, const Vec2& p) {
  const int above = terrain.first_segment(p.x());
  const double depth = std::max({terrain.start(above).y(), terrain.end(above).y(), p.y()}) - p.y();
  const auto run = terrain.segments_between(p.x() - depth, p.x() + depth);
  ContactPoint<2> nearest;
  nearest.gap = -1e300;
  for (int i = run.first; i <= run.last; ++i) {
    const double s = std::clamp((p - terrain.start(i)).dot(terrain.tangent(i)), 0.0, terrain.length(i));
    const double gap = -(terrain.start(i) + s * terrain.tangent(i) - p).norm();
    if (gap > nearest.gap) {
      nearest.gap = gap;
      nearest.normal = terrain.normal(i);
      nearest.against = segment_id(i);
    }
  }
  return nearest;
}

/// Contact points with segments, for a point grown by a radius: the centre of a disk, or a vertex with radius
/// 0. A point below the line of a segment is either in the ground, or above another part of the polyline and
/// free.
void point_contacts(const Vec2& p, double radius, FeatureId feature, const Terrain2& terrain,
                    const Terrain2::Run& run, double reach, double shallow, Contacts& out) {
  bool deep = false;
  for (int i = run.first; i <= run.last; ++i) {
    const double height = (p - terrain.start(i)).dot(terrain.normal(i));
    const double gap = height - radius;
    if (gap > reach || !owns(terrain, i, p, shallow)) continue;
    if (height < -reach && p.y() >= terrain.height(p.x())) continue;
    if (height < -shallow)
      deep = true;
    else
      out.push_back(
          {p - (radius + 0.5 * gap) * terrain.normal(i), terrain.normal(i), gap, feature, segment_id(i)});
  }
  if (!deep) return;
  ContactPoint<2> place = nearest_place(terrain, p);
  place.gap -= radius;
  place.point = p - (radius + 0.5 * place.gap) * place.normal;
  place.feature = feature;
  out.push_back(place);
}

/// Contact points of a disk, or of an end of a wall, with segments and convex corners. The cone of an end
/// reaches to where the sides of the wall have the contact; `outward` leads out of the wall there, and is
/// zero for a disk.
void round_contacts(const Vec2& centre, double radius, const Vec2& outward, FeatureId feature,
                    const Terrain2& terrain, const Terrain2::Run& run, double reach, Contacts& out) {
  const double shallow = shallow_share * (radius > 0 ? radius : 1e-3);  // of a point 1 um
  point_contacts(centre, radius, feature, terrain, run, reach, shallow, out);
  for (int i = std::max(run.first, 1); i <= std::min(run.last + 1, terrain.segments() - 1); ++i) {
    if (terrain.corner(i) != Corner::convex || radius == 0) continue;
    const Vec2 away = centre - terrain.point(i);
    const double distance = away.norm(), gap = distance - radius;
    // Only strictly inside the cone, because on its sides the segments give the contact.
    if (gap > reach || away.dot(terrain.tangent(i - 1)) <= 1e-9 * terrain.length(i - 1) ||
        away.dot(terrain.tangent(i)) >= -1e-9 * terrain.length(i) || outward.dot(away) > 0)
      continue;
    const Vec2 normal = away / distance;
    out.push_back({terrain.point(i) + 0.5 * gap * normal, normal, gap, feature, corner_id(i)});
  }
}

/// Contact points of the edges of a polygon or a wall with convex corners.
void edge_contacts(const Placed2& polygon, int index, const Terrain2& terrain, const Terrain2::Run& run,
                   double reach, double cone_slack, Contacts& out) {
  const int n = polygon.count();
  for (int i = std::max(run.first, 1); i <= std::min(run.last + 1, terrain.segments() - 1); ++i) {
    if (terrain.corner(i) != Corner::convex) continue;
    const Vec2& corner = terrain.point(i);
    int edge = 0;
    double gap = -1e300;
    const double farthest = reach + polygon.shape.radius;
    for (int e = 0; e < n && gap <= farthest; ++e)
      if (const double outside = polygon.outside(e, corner); outside > gap) gap = outside, edge = e;
    gap -= polygon.shape.radius;
    const Vec2 normal = -polygon.normal(edge);
    if (gap > reach || !in_cone(terrain, i, normal, cone_slack)) continue;
    // If a vertex stands on the corner, or the end of a wall is over it, this gives the contact.
    const Vec2 a = polygon.point(edge), b = polygon.point((edge + 1) % n);
    if (n == 2 && ((corner - a).dot(b - a) <= 0 || (corner - b).dot(a - b) <= 0)) continue;
    if (std::min((a - corner).norm(), (b - corner).norm()) <= 1e-7 * (b - a).norm()) continue;
    out.push_back({corner + 0.5 * gap * normal, normal, gap, edge_id(index, edge), corner_id(i)});
  }
}

}  // namespace

void terrain_contacts(const Placed2& contactor, int contactor_index, const Terrain2& terrain, double reach,
                      double turn, std::vector<ContactPoint<2>>& out) {
  if (contactor.shape.is_room()) return;
  double low = contactor.point(0).x(), high = low;
  for (int i = 1; i < contactor.count(); ++i) {
    low = std::min(low, contactor.point(i).x());
    high = std::max(high, contactor.point(i).x());
  }
  const double grow = contactor.shape.radius + reach;
  const auto run = terrain.segments_between(low - grow, high + grow);
  if (contactor.count() == 1) {
    round_contacts(contactor.point(0), contactor.shape.radius, Vec2::Zero(), vertex_id(contactor_index, 0),
                   terrain, run, reach, out);
    return;
  }
  const double radius = contactor.shape.radius, shallow = shallow_share * contactor.shape.bound;
  for (int k = 0; k < contactor.count(); ++k) {
    const Vec2 point = contactor.point(k);
    if (radius > 0)
      round_contacts(point, radius, point - contactor.point(1 - k), vertex_id(contactor_index, k), terrain,
                     run, reach, out);
    else
      point_contacts(point, 0, vertex_id(contactor_index, k), terrain, run, reach, shallow, out);
  }
  // The corner at the end of a segment holds a polygon that lies flush on it, up to this angle [rad].
  constexpr double flush = 1e-4;
  edge_contacts(contactor, contactor_index, terrain, run, reach, flush + turn, out);
}

}  // namespace flyrock
