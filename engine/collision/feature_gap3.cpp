#include <cmath>
#include <optional>

#include "collision/facing.h"
#include "collision/feature_gap.h"
#include "collision/ground_piece.h"
#include "collision/room.h"
#include "collision/surface.h"

namespace flyrock {

namespace {

Vec3 edge_start(const Placed3& shape, int edge) { return shape.point(shape.shape.edges[edge].start); }
Vec3 edge_direction(const Placed3& shape, int edge) {
  return (shape.point(shape.shape.edges[edge].end) - edge_start(shape, edge)).normalized();
}
/// The sum of the normals of the two faces at the edge.
Vec3 edge_outward(const Placed3& shape, int edge) {
  return shape.normal(shape.shape.edges[edge].left) + shape.normal(shape.shape.edges[edge].right);
}

/// The distance of two edges along the normal across both. The axis of a pill is never below another edge.
double edge_edge(const Placed3& a, int ea, const Placed3& b, int eb) {
  const Vec3 da = edge_direction(a, ea), db = edge_direction(b, eb);
  const Vec3 away = edge_start(a, ea) - edge_start(b, eb);
  Vec3 normal = da.cross(db);
  if (!a.shape.has_faces() || !b.shape.has_faces())
    return normal.norm() < 1e-9 ? da.cross(away).norm() : std::abs(normal.normalized().dot(away));
  const Vec3 from_b_to_a = edge_outward(b, eb) - edge_outward(a, ea);
  if (normal.norm() < 1e-9) normal = from_b_to_a - da * da.dot(from_b_to_a);  // parallel
  if (normal.dot(from_b_to_a) < 0) normal = -normal;
  return normal.normalized().dot(away);
}

/// The distance of the vertex `v` of a from a feature of b.
double from_vertex(const Placed3& a, int v, const Placed3& b, FeatureId feature) {
  const Vec3 p = a.point(v);
  const int i = index_of(feature);
  switch (kind_of(feature)) {
    case FeatureKind::face:
      return b.outside(i, p);
    case FeatureKind::edge:
      return edge_direction(b, i).cross(p - edge_start(b, i)).norm();
    case FeatureKind::vertex:
      break;
  }
  return (p - b.point(i)).norm();
}

/// The distance of p from the two facets at a convex rim. A sphere that has rolled past the rim is over one
/// of them.
double from_rim(const Facet& f, int rim, const Vec3& p) {
  const Vec3 along = f.along(rim), away = p - f.corner[rim];
  if (away.dot(f.normal.cross(along)) > 0) return away.dot(f.normal);
  if (away.dot(along.cross(f.beyond[rim])) > 0) return away.dot(f.beyond[rim]);
  return along.normalized().cross(away).norm();
}

/// The place of a vertex or of a rim that faces a direction, if the feature is one.
std::optional<Vec3> place_of(const Placed3& shape, FeatureId feature, const Vec3& direction) {
  const int i = index_of(feature);
  if (kind_of(feature) == FeatureKind::vertex) return shape.point(i);
  if (kind_of(feature) == FeatureKind::face || !shape.shape.has_circles() || place_of_rim(i) >= rim_places)
    return std::nullopt;
  return rim_place(shape, i, direction);
}

/// The plane of a face or cap: a place on it and its normal.
struct FacePlane {
  Vec3 at, normal;
};
std::optional<FacePlane> plane_of(const Placed3& shape, FeatureId feature) {
  if (kind_of(feature) != FeatureKind::face) return std::nullopt;
  const int i = index_of(feature);
  if (!shape.shape.has_circles()) return FacePlane{shape.corner(i, 0), shape.normal(i)};
  if (i == side_face) return std::nullopt;
  const Contactor3::Circle& circle = shape.shape.circles[i];
  return FacePlane{shape.pose * circle.centre, shape.pose.r * circle.axis};
}

/// The height of a vertex, or of the place of a rim that faces a plane, over this plane.
std::optional<double> over_plane(const Placed3& shape, FeatureId feature,
                                 const std::optional<FacePlane>& plane) {
  if (!plane) return std::nullopt;
  const auto place = place_of(shape, feature, -plane->normal);
  if (!place) return std::nullopt;
  return plane->normal.dot(*place - plane->at);
}

/// The gap of a pair one of which has circles: over the plane of a face, else along the normal of the pair.
double gap_with_circles(const Placed3& a, FeatureId feature, const Placed3& b, FeatureId against) {
  for (const auto& height :
       {over_plane(a, feature, plane_of(b, against)), over_plane(b, against, plane_of(a, feature))})
    if (height) return *height - a.shape.radius - b.shape.radius;
  const FacingPair pair = facing_pair(a, b);
  const Vec3& normal = pair.apart.normal;
  const double radii = a.shape.radius + b.shape.radius;
  if (const auto of_a = place_of(a, feature, -normal)) return normal.dot(*of_a - b.support(normal)) - radii;
  const auto of_b = place_of(b, against, normal);
  if (!of_b) return pair.apart.distance - radii;
  if (pair.of_a.normal.squaredNorm() > 0)  // over a face or cap
    return pair.of_a.normal.dot(*of_b - place_on(pair.of_a)) - radii;
  return normal.dot(a.support(-normal) - *of_b) - radii;
}

}  // namespace

double feature_gap(const Placed3& contactor, FeatureId feature, const Ground3& ground, FeatureId against) {
  const Facet f = ground.facet(ground.facet_of(against));
  const double radius = contactor.shape.radius;
  if (contactor.shape.has_circles()) {
    if (kind_of(against) == FeatureKind::face)
      return f.distance(*place_of(contactor, feature, -f.normal)) - radius;
    if (kind_of(against) == FeatureKind::vertex)
      return gap_with_circles(contactor, feature, vertex_piece(ground.vertex(ground_index(against))),
                              feature_id(0, FeatureKind::vertex, 0));
    return gap_with_circles(contactor, feature, edge_piece(f, static_cast<int>(ground_index(against) % 3)),
                            feature_id(0, FeatureKind::edge, 0));
  }
  switch (kind_of(against)) {
    case FeatureKind::face:
      return f.distance(contactor.point(index_of(feature))) - radius;
    case FeatureKind::vertex: {
      const Vec3 top = ground.vertex(ground_index(against));
      if (kind_of(feature) == FeatureKind::vertex)
        return (contactor.point(index_of(feature)) - top).norm() - radius;
      if (kind_of(feature) == FeatureKind::edge)
        return edge_direction(contactor, index_of(feature))
                   .cross(top - edge_start(contactor, index_of(feature)))
                   .norm() -
               radius;
      return contactor.outside(index_of(feature), top);
    }
    case FeatureKind::edge:
      break;
  }
  const int rim = static_cast<int>(ground_index(against) % 3);
  const Vec3 along = f.along(rim).normalized();
  if (kind_of(feature) == FeatureKind::vertex)
    return from_rim(f, rim, contactor.point(index_of(feature))) - radius;
  Vec3 normal = along.cross(edge_direction(contactor, index_of(feature)));
  if (normal.dot(f.normal + f.beyond[rim]) < 0) normal = -normal;
  return normal.normalized().dot(edge_start(contactor, index_of(feature)) - f.corner[rim]) - radius;
}

double feature_gap(const Placed3& candidate, FeatureId feature, const Placed3& antagonist,
                   FeatureId against) {
  if (candidate.shape.is_surface() || antagonist.shape.is_surface())
    return surface_gap<3>(candidate, feature, antagonist, against);
  if (candidate.shape.is_room() || antagonist.shape.is_room())
    return room_gap(candidate, feature, antagonist, against);
  if (candidate.shape.has_circles() || antagonist.shape.has_circles())
    return gap_with_circles(candidate, feature, antagonist, against);
  const FeatureKind of_candidate = kind_of(feature), of_antagonist = kind_of(against);
  const double radii = candidate.shape.radius + antagonist.shape.radius;
  if (of_candidate == FeatureKind::vertex)
    return from_vertex(candidate, index_of(feature), antagonist, against) - radii;
  if (of_antagonist == FeatureKind::vertex)
    return from_vertex(antagonist, index_of(against), candidate, feature) - radii;
  return edge_edge(candidate, index_of(feature), antagonist, index_of(against)) - radii;
}

}  // namespace flyrock
