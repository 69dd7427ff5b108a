// Gaps of known features of balls, pills and polyhedra in 3D.
#include "collision/pill/closest.h"
#include "collision/rules.h"
#include "geometry/ground.h"

namespace flyrock {

namespace {

Vec3 edge_start(const Placed3& shape, int edge) { return shape.point(shape.shape.edges[edge].start); }
Vec3 edge_vector(const Placed3& shape, int edge) {
  return shape.point(shape.shape.edges[edge].end) - edge_start(shape, edge);
}
Vec3 edge_direction(const Placed3& shape, int edge) { return edge_vector(shape, edge).normalized(); }
/// The sum of the normals of the two faces at the edge.
Vec3 edge_outward(const Placed3& shape, int edge) {
  return shape.normal(shape.shape.edges[edge].left) + shape.normal(shape.shape.edges[edge].right);
}

/// Between the nearest places of two edges, of which the first starts `away` from the second. The axis of a
/// pill and an edge may be nearly parallel: their lines would cross far beyond their ends.
Vec3 between_nearest(const Vec3& away, const Vec3& along_a, const Vec3& along_b) {
  const auto [s, t] = nearest_of_segments(away, along_a, Vec3::Zero(), along_b);
  return away + s * along_a - t * along_b;
}

/// The distance of two edges along the normal across both. With a pill it has no sign: of an axis that
/// pierces a polyhedron, deeper than its radius, it is wrong.
double edge_edge(const Placed3& a, int ea, const Placed3& b, int eb) {
  const Vec3 away = edge_start(a, ea) - edge_start(b, eb);
  if (a.shape.faces.empty() || b.shape.faces.empty())
    return between_nearest(away, edge_vector(a, ea), edge_vector(b, eb)).norm();
  const Vec3 da = edge_direction(a, ea), db = edge_direction(b, eb);
  Vec3 normal = da.cross(db);
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

}  // namespace

double core_gap_to_ground(Workspace&, const Placed3& contactor, FeatureId feature, const Ground3& ground,
                          FeatureId against, const Vec3&) {
  const Facet f = ground.facet(ground.facet_of(against));
  const double radius = contactor.shape.radius;
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
  const Vec3 outward = f.normal + f.beyond[rim],
             away = edge_start(contactor, index_of(feature)) - f.corner[rim];
  if (contactor.shape.faces.empty()) {
    const Vec3 apart = between_nearest(away, edge_vector(contactor, index_of(feature)), f.along(rim));
    return (apart.dot(outward) < 0 ? -1 : 1) * apart.norm() - radius;
  }
  Vec3 normal = along.cross(edge_direction(contactor, index_of(feature)));
  if (normal.dot(outward) < 0) normal = -normal;
  return normal.normalized().dot(away) - radius;
}

double core_gap(Workspace&, const Placed3& candidate, FeatureId feature, const Placed3& antagonist,
                FeatureId against, const Vec3&) {
  const FeatureKind of_candidate = kind_of(feature), of_antagonist = kind_of(against);
  const double radii = candidate.shape.radius + antagonist.shape.radius;
  if (of_candidate == FeatureKind::vertex)
    return from_vertex(candidate, index_of(feature), antagonist, against) - radii;
  if (of_antagonist == FeatureKind::vertex)
    return from_vertex(antagonist, index_of(against), candidate, feature) - radii;
  return edge_edge(candidate, index_of(feature), antagonist, index_of(against)) - radii;
}

}  // namespace flyrock
