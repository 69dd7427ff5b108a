#include "collision/separating_direction.h"

#include <limits>

namespace flyrock {

SeparatingDirection face_direction(const MovingContactor& c, SeparatingDirection::Kind kind, int f) {
  const Contactor3::Face& face = c.shape.faces[f];
  const double support = face.normal.dot(c.shape.points[c.shape.vertex(face, 0)]);
  return {kind, face.normal, support, c.id(FeatureKind::face, f), 0, 0, 1};
}

SeparatingDirection attached_direction(const MovingContactor& c, const MovingState& state,
                                       SeparatingDirection::Kind kind, const Vec3& outward,
                                       const ShapeFeature& feature) {
  SeparatingDirection d;
  d.kind = kind;
  d.local = state.turn.rotation.inverse(outward);
  d.feature = c.id(feature.kind, feature.index);
  d.support = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : c.shape.points) d.support = std::max(d.support, d.local.dot(p));
  return d;
}

SeparatingDirection across_edges(const EdgeAxis& axis, const Placed3& a, const Placed3& b) {
  const auto along = [](const Placed3& p, int e) {
    return Vec3(p.point(p.shape.edges[e].end) - p.point(p.shape.edges[e].start));
  };
  SeparatingDirection d;
  d.kind = SeparatingDirection::Kind::edges;
  d.edge_a = axis.of_a;
  d.edge_b = axis.of_b;
  d.sign = along(a, axis.of_a).cross(along(b, axis.of_b)).dot(axis.normal) > 0 ? -1 : 1;
  return d;
}

}  // namespace flyrock
