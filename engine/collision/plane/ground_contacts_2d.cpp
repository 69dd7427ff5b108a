// Contacts of balls, pills and hulls with a line of segments in 2D.
#include <algorithm>

#include "collision/ground/facet_region.h"
#include "collision/rules.h"

namespace flyrock {

namespace {

bool in_cone(const Ground2& ground, int corner, const Vec2& direction, double slack) {
  return direction.dot(ground.tangent(corner - 1)) >= -slack &&
         direction.dot(ground.tangent(corner)) <= slack;
}

/// Whether vertex k of a hull is its lowest along a direction, in the frame of the hull, up to `reach` [m]
/// and while the hull turns by `turn` [rad]. Only then a segment with this normal can hold it: a vertex on a
/// convex corner is within reach of both segments there, also of the one that cannot.
bool can_be_lowest(const Contactor2& shape, int k, const Vec2& up, double reach, double turn) {
  const int n = static_cast<int>(shape.points.size());
  const auto rises_to = [&](int other) {
    const Vec2 along = shape.points[other] - shape.points[k];
    return up.dot(along) >= -reach - turn * along.norm();
  };
  return n == 1 || (rises_to((k + 1) % n) && rises_to((k + n - 1) % n));
}

/// Whether the strip of the segment contains p. At a flat or convex corner only the right segment owns the
/// point, if it can hold it. At a concave corner both segments own it, and the strip is longer by `shallow`,
/// because the point may have sunk into the other segment.
template <class CanHold>
bool owns(const Ground2& ground, int segment, const Vec2& p, double shallow, const CanHold& can_hold) {
  const double length = ground.length(segment), slack = region_slack * length;
  const double s = (p - ground.start(segment)).dot(ground.tangent(segment));
  const int next = segment + 1;
  const bool concave_start = ground.corner(segment) == Corner::concave,
             concave_end = ground.corner(next) == Corner::concave;
  if (s < -(concave_start ? shallow : slack) || s > length + (concave_end ? shallow : slack)) return false;
  if (s <= length - slack || next >= ground.segments() || concave_end) return true;
  return (p - ground.start(next)).dot(ground.tangent(next)) < -slack || !can_hold(next);
}

/// The point of the polyline that is nearest to a point in the ground.
ContactPoint<2> nearest_place(const Ground2& ground, const Vec2& p) {
  const Ground2::Run run = ground.near_inside(p);
  ContactPoint<2> nearest;
  nearest.gap = -1e300;
  for (int i = run.first; i <= run.last; ++i) {
    const double s = std::clamp((p - ground.start(i)).dot(ground.tangent(i)), 0.0, ground.length(i));
    const double gap = -(ground.start(i) + s * ground.tangent(i) - p).norm();
    if (gap > nearest.gap) {
      nearest.gap = gap;
      nearest.normal = ground.normal(i);
      nearest.against = segment_id(i);
    }
  }
  return nearest;
}

/// The contact of a vertex, grown by a radius, with segment i. A vertex below the line of a segment is either
/// in the ground, or above another part of the polyline and free. Returns whether it is so deep in the ground
/// that the nearest place is its contact instead. can_hold(j): whether segment j can hold the vertex.
template <class CanHold>
bool point_contact(const Vec2& p, double radius, FeatureId feature, const Ground2& ground, int i,
                   double reach, double shallow, const CanHold& can_hold, Contacts<2>& out) {
  const double height = (p - ground.start(i)).dot(ground.normal(i));
  const double gap = height - radius;
  if (gap > reach || !owns(ground, i, p, shallow, can_hold)) return false;
  if (height < -reach && !ground.is_inside(p)) return false;
  if (height < -shallow) return true;
  out.push_back({p - (radius + 0.5 * gap) * ground.normal(i), ground.normal(i), gap, feature, segment_id(i)});
  return false;
}

/// The contact of a point deep in the ground.
void deep_contact(const Vec2& p, double radius, FeatureId feature, const Ground2& ground, Contacts<2>& out) {
  ContactPoint<2> place = nearest_place(ground, p);
  place.gap -= radius;
  place.point = p - (radius + 0.5 * place.gap) * place.normal;
  place.feature = feature;
  out.push_back(place);
}

void point_contacts(const Vec2& p, double radius, FeatureId feature, const Ground2& ground,
                    const Ground2::Run& run, double reach, double shallow, Contacts<2>& out) {
  const auto holds = [](int) { return true; };
  bool deep = false;
  for (int i = run.first; i <= run.last; ++i)
    if (point_contact(p, radius, feature, ground, i, reach, shallow, holds, out)) deep = true;
  if (deep) deep_contact(p, radius, feature, ground, out);
}

/// Contact points of the vertices with segments, ordered by vertex and segment.
void vertex_contacts(const Placed2& placed, const Ground2& ground, const Ground2::Run& run, double reach,
                     double turn, Contacts<2>& out) {
  constexpr double rounding = 1e-9;
  const double radius = placed.shape.radius, bound = placed.shape.bound;
  const double shallow = shallow_share * (bound > 0 ? bound : 1e-3);  // of a point 1 um
  const double lowest_vertex = -(1 + rounding) * bound;
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  const Vec2* const points = placed.shape.points.data();
  const int count = placed.count();
  bool deep = false;
  for (int i = run.first; i <= run.last; ++i) {
    const double highest = reach + radius - ground.normal(i).dot(placed.pose.x - ground.start(i));
    if (highest < lowest_vertex) continue;
    // In the frame of the contactor, a vertex that is too high costs one product.
    const Vec2 rise = placed.pose.r.inverse(ground.normal(i));
    for (int k = 0; k < count; ++k) {
      if (rise.dot(points[k]) > highest || !can_be_lowest(placed.shape, k, rise, reach, turn)) continue;
      const auto can_hold = [&](int j) {
        return can_be_lowest(placed.shape, k, placed.pose.r.inverse(ground.normal(j)), reach, turn);
      };
      deep |=
          point_contact(placed.point(k), radius, placed.vertex(k), ground, i, reach, shallow, can_hold, out);
    }
  }
  if (deep) {
    out.resize(static_cast<std::size_t>(first));
    for (int k = 0; k < count; ++k)
      point_contacts(placed.point(k), radius, placed.vertex(k), ground, run, reach, shallow, out);
  }
  if (out.end() - out.begin() - first < 2) return;
  std::sort(out.begin() + first, out.end(), [](const ContactPoint<2>& a, const ContactPoint<2>& b) {
    return a.feature != b.feature ? a.feature < b.feature : a.against < b.against;
  });
}

/// The edge of a hull that separates a place in its frame most, of those for which counts(edge), and its
/// separation [m]. The search ends at an edge that separates by more than `farthest`.
struct NearEdge {
  int edge = 0;
  double distance = -1e300;
};
template <class Counts>
NearEdge near_edge(const Contactor2& shape, const Vec2& local, double farthest, const Counts& counts) {
  NearEdge best;
  const int n = static_cast<int>(shape.points.size());
  for (int e = 0; e < n && best.distance <= farthest; ++e) {
    const double outside = shape.normals[e].dot(local - shape.points[e]);
    if (outside > best.distance && counts(e)) best = {e, outside};
  }
  return best;
}

/// The contact of a rounded vertex with a convex corner.
void round_contact(const Vec2& centre, double radius, FeatureId feature, const Ground2& ground, int corner,
                   double reach, Contacts<2>& out) {
  const Vec2 away = centre - ground.point(corner);
  const double distance = away.norm(), gap = distance - radius;
  // Only strictly inside the cone, because on its sides the segments give the contact.
  if (gap > reach || away.dot(ground.tangent(corner - 1)) <= region_slack * ground.length(corner - 1) ||
      away.dot(ground.tangent(corner)) >= -region_slack * ground.length(corner))
    return;
  const Vec2 normal = away / distance;
  out.push_back({ground.point(corner) + 0.5 * gap * normal, normal, gap, feature, corner_id(corner)});
}

/// The edge of a hull that faces a convex corner at a place in its frame. Of a corner in the hull, less deep
/// than `shallow`, it is an edge whose normal lies in the cone of the corner: beside the end of an edge, the
/// corner is nearer to the other edge of the vertex there, along which nothing can push it out.
NearEdge facing_edge(const Placed2& placed, const Ground2& ground, int corner, const Vec2& local,
                     double farthest, double shallow, double cone_slack) {
  const NearEdge near = near_edge(placed.shape, local, farthest, [](int) { return true; });
  const auto faces = [&](int edge) { return in_cone(ground, corner, -placed.normal(edge), cone_slack); };
  if (near.distance > 0 || near.distance < -shallow || faces(near.edge)) return near;
  const NearEdge facing = near_edge(placed.shape, local, farthest, faces);
  return facing.distance >= -shallow ? facing : near;
}

/// Contact points with convex corners: of the edge of the hull that a corner faces, or of the rounded vertex
/// if the corner is beyond the end of this edge. Sharp vertices meet segments only.
void corner_contacts(const Placed2& placed, const Ground2& ground, const Ground2::Run& run, double reach,
                     double cone_slack, Contacts<2>& out) {
  const int n = placed.count();
  const double shallow = shallow_share * placed.shape.bound;
  const double radius = placed.shape.radius, around = placed.shape.bound + reach;
  if (n == 1 && radius == 0) return;
  for (int i = std::max(run.first, 1); i <= std::min(run.last + 1, ground.segments() - 1); ++i) {
    if (ground.corner(i) != Corner::convex) continue;
    const auto meet_vertex = [&](int k) {
      round_contact(placed.point(k), radius, placed.vertex(k), ground, i, reach, out);
    };
    if (n == 1) {
      meet_vertex(0);
      continue;
    }
    const Vec2& corner = ground.point(i);
    const Vec2 local = placed.pose.r.inverse(corner - placed.pose.x);
    if (local.squaredNorm() > around * around) continue;
    const NearEdge near = facing_edge(placed, ground, i, local, reach + radius, shallow, cone_slack);
    const double gap = near.distance - radius;
    if (gap > reach) continue;
    const int next = (near.edge + 1) % n;
    const Vec2 a = placed.point(near.edge), b = placed.point(next);
    if (radius > 0) {
      const bool before = (corner - a).dot(b - a) <= 0, beyond = (corner - b).dot(a - b) <= 0;
      if (before || beyond) {
        meet_vertex(before ? near.edge : next);
        continue;
      }
    }
    const Vec2 normal = -placed.normal(near.edge);
    if (!in_cone(ground, i, normal, cone_slack)) continue;
    // If a vertex stands on the corner, the segments give the contact.
    const double on_segments = region_slack * std::min(ground.length(i - 1), ground.length(i));
    if (std::min((a - corner).norm(), (b - corner).norm()) <= on_segments) continue;
    out.push_back({corner + 0.5 * gap * normal, normal, gap, placed.edge(near.edge), corner_id(i)});
  }
}

/// The segments that are below or above a contactor and its reach. Of a polygon these are the ones at its
/// circle, because one that is too low costs less than to find the ends of the polygon.
Ground2::Run segments_near(const Placed2& contactor, const Ground2& ground, double reach) {
  const double x = contactor.pose.x.x(), grow = contactor.shape.radius + reach;
  if (contactor.count() > 2) {
    const double extent = contactor.shape.bound + grow;
    return ground.segments_between(x - extent, x + extent);
  }
  // From the centre, along x
  const Vec2 along(contactor.pose.r.c, -contactor.pose.r.s);
  double low = along.dot(contactor.shape.points[0]), high = low;
  for (const Vec2& point : contactor.shape.points) {
    low = std::min(low, along.dot(point));
    high = std::max(high, along.dot(point));
  }
  return ground.segments_between(x + low - grow, x + high + grow);
}

}  // namespace

void hull_on_ground(Workspace&, const Placed2& contactor, const Ground2& ground, double reach, double turn,
                    Contacts<2>& out) {
  const auto run = segments_near(contactor, ground, reach);
  vertex_contacts(contactor, ground, run, reach, flush_angle + turn, out);
  // The corner at the end of a segment holds an edge that lies flush on it.
  corner_contacts(contactor, ground, run, reach, flush_angle + turn, out);
}

}  // namespace flyrock
