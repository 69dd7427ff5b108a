#include "collision/round_contact.h"

#include <algorithm>
#include <limits>

namespace flyrock {

namespace {

/// The point of one face that is nearest to a point above it, in the frame of the shape.
NearestPlace nearest_of_face(const Contactor3& shape, int f, double above, const Vec3& point) {
  const Contactor3::Face& face = shape.faces[f];
  NearestPlace best{above, face.normal, FeatureKind::face, f};
  bool over = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < face.count; ++i) {
    const Vec3& a = shape.points[shape.vertex(face, i)];
    const Vec3 along = shape.points[shape.vertex(face, (i + 1) % face.count)] - a;
    const Vec3 away = point - a;
    if (along.cross(face.normal).dot(away) <= 0) continue;
    over = false;
    const double s = away.dot(along) / along.squaredNorm();
    const Vec3 from_edge = away - std::clamp(s, 0.0, 1.0) * along;
    const double distance = from_edge.norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best.distance = distance;
    best.normal = distance > 0 ? Vec3(from_edge / distance) : face.normal;
    best.kind = s > 0 && s < 1 ? FeatureKind::edge : FeatureKind::vertex;
    best.index = s <= 0   ? shape.vertex(face, i)
                 : s >= 1 ? shape.vertex(face, (i + 1) % face.count)
                          : shape.loop_edge[face.first + i];
  }
  if (over) best = {above, face.normal, FeatureKind::face, f};
  return best;
}

}  // namespace

NearestPlace nearest_place(const Placed3& polyhedron, const Vec3& point) {
  const Contactor3& shape = polyhedron.shape;
  const Vec3 local = polyhedron.pose.r.inverse(point - polyhedron.pose.x);
  NearestPlace inside{-std::numeric_limits<double>::infinity(), Vec3::UnitZ(), FeatureKind::face, 0};
  NearestPlace outside{std::numeric_limits<double>::infinity(), Vec3::UnitZ(), FeatureKind::face, 0};
  const bool flat = polyhedron.faces() == 2;  // a facet of the ground has no inside
  for (int f = 0; f < polyhedron.faces(); ++f) {
    const double above = shape.faces[f].normal.dot(local - shape.points[shape.vertex(shape.faces[f], 0)]);
    if (above > inside.distance) inside = {above, shape.faces[f].normal, FeatureKind::face, f};
    if (flat ? above < 0 : above <= 0) continue;
    // The nearest point lies on a face that is visible from the given point.
    const NearestPlace place = nearest_of_face(shape, f, above, local);
    if (place.distance < outside.distance) outside = place;
  }
  NearestPlace& nearest = flat || inside.distance > 0 ? outside : inside;
  nearest.normal = polyhedron.pose.r * nearest.normal;
  return nearest;
}

}  // namespace flyrock
