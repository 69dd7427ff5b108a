#include "collision/pill/closest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

// Segments whose angle has a smaller sine than this are parallel.
constexpr double parallel_sine = 1e-8;

/// The place of a parameter on an edge or on the core of a sphere: a vertex at its ends.
ShapeFeature feature_at(double s, int start, int end, int edge) {
  if (s <= 0) return {FeatureKind::vertex, start};
  if (s >= 1) return {FeatureKind::vertex, end};
  return {FeatureKind::edge, edge};
}

Vec3 any_normal_to(const Vec3& along) {
  const Vec3 across = along.cross(std::abs(along.x()) < 0.5 * along.norm() ? Vec3::UnitX() : Vec3::UnitY());
  return across.norm() > 0 ? Vec3(across.normalized()) : Vec3::UnitZ();
}

/// The feature of a polyhedron that is nearest to a point in the world. For a point inside, the nearest face
/// plane.
struct NearestPlace {
  double distance = 0;          ///< m, negative inside
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the polyhedron towards the point
  FeatureKind kind = FeatureKind::face;
  int index = 0;  ///< of the vertex, edge or face
};

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

/// Two cores without faces.
Closest of_segments(const Placed3& a, const Placed3& b) {
  const Vec3 p = a.point(0), dp = a.point(a.count() - 1) - p;
  const Vec3 q = b.point(0), dq = b.point(b.count() - 1) - q;
  const auto [s, t] = nearest_of_segments(p, dp, q, dq);
  Closest found;
  found.on_a = p + s * dp;
  const Vec3 away = found.on_a - (q + t * dq), across = dp.cross(dq);
  found.distance = away.norm();
  if (found.distance > 0)
    found.normal = away / found.distance;
  else
    found.normal = across.norm() > 0 ? Vec3(across.normalized()) : any_normal_to(a.count() > 1 ? dp : dq);
  if (a.count() > 1) found.of_a = feature_at(s, 0, 1, 0);
  if (b.count() > 1) found.of_b = feature_at(t, 0, 1, 0);
  return found;
}

/// Whether a segment passes through a polyhedron. In the frame of the polyhedron, as all that follows.
bool pierces(const Vec3& p, const Vec3& dp, const Contactor3& shape) {
  double enters = 0, leaves = 1;
  for (const Contactor3::Face& face : shape.faces) {
    const double above = face.normal.dot(p - shape.points[shape.vertex(face, 0)]), rise = face.normal.dot(dp);
    if (rise == 0 && above > 0) return false;
    if (rise < 0) enters = std::max(enters, -above / rise);
    if (rise > 0) leaves = std::min(leaves, -above / rise);
    if (enters > leaves) return false;
  }
  if (shape.faces.size() > 2) return true;
  // A facet of the ground has only its front and its back: the place in its plane must be inside its edges.
  const Vec3 place = p + enters * dp;
  const Contactor3::Face& front = shape.faces[0];
  for (int i = 0; i < front.count; ++i) {
    const Vec3& corner = shape.points[shape.vertex(front, i)];
    const Vec3 along = shape.points[shape.vertex(front, (i + 1) % front.count)] - corner;
    if (along.cross(front.normal).dot(place - corner) > 0) return false;
  }
  return true;
}

/// The direction in which a segment that pierces a polyhedron comes out soonest (separating axes).
Closest shallowest(const Vec3& p, const Vec3& dp, const Contactor3& shape) {
  Closest found;
  found.distance = -infinite;
  for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f) {
    const Contactor3::Face& face = shape.faces[f];
    const double above = face.normal.dot(p - shape.points[shape.vertex(face, 0)]), rise = face.normal.dot(dp);
    const double lowest = above + std::min(rise, 0.0);
    if (lowest <= found.distance) continue;
    const int end = rise < 0;
    found = {lowest, face.normal, p + end * dp, {FeatureKind::vertex, end}, {FeatureKind::face, f}};
  }
  for (int e = 0; e < static_cast<int>(shape.edges.size()); ++e) {
    const Contactor3::Edge& edge = shape.edges[e];
    const Vec3 &from = shape.points[edge.start], along = shape.points[edge.end] - from;
    // Both faces lead away from the edge in these directions.
    const Vec3 left = shape.faces[edge.left].normal.cross(along),
               right = along.cross(shape.faces[edge.right].normal);
    Vec3 axis = dp.cross(along);
    const double length = axis.norm();
    if (length <= parallel_sine * dp.norm() * along.norm()) continue;
    axis /= axis.dot(left + right) > 0 ? -length : length;
    if (axis.dot(left) > 0 || axis.dot(right) > 0) continue;
    const double separation = axis.dot(p - from);
    if (separation <= found.distance) continue;
    const double s = nearest_of_segments(p, dp, from, along).s;
    found = {separation, axis, p + s * dp, {FeatureKind::edge, 0}, {FeatureKind::edge, e}};
  }
  return found;
}

/// A pill outside of a polyhedron is nearest with an end, or with its axis at an edge.
Closest outside(const Placed3& pill, const Vec3& p, const Vec3& dp, const Placed3& polyhedron) {
  Closest found;
  found.distance = infinite;
  for (int end = 0; end < 2; ++end) {
    const NearestPlace place = nearest_place(polyhedron, pill.point(end));
    if (place.distance < found.distance)
      found = {place.distance,
               polyhedron.pose.r.inverse(place.normal),
               p + end * dp,
               {FeatureKind::vertex, end},
               {place.kind, place.index}};
  }
  const Contactor3& shape = polyhedron.shape;
  for (int e = 0; e < static_cast<int>(shape.edges.size()); ++e) {
    const Contactor3::Edge& edge = shape.edges[e];
    const Vec3 &from = shape.points[edge.start], along = shape.points[edge.end] - from;
    const auto [s, t] = nearest_of_segments(p, dp, from, along);
    if (s <= 0 || s >= 1) continue;
    const Vec3 place = p + s * dp, away = place - (from + t * along);
    const double distance = away.norm();
    if (distance < found.distance && distance > 0)
      found = {
          distance, away / distance, place, {FeatureKind::edge, 0}, feature_at(t, edge.start, edge.end, e)};
  }
  return found;
}

Closest with_polyhedron(const Placed3& a, const Placed3& polyhedron) {
  if (a.count() == 1) {
    const NearestPlace place = nearest_place(polyhedron, a.point(0));
    return {place.distance, place.normal, a.point(0), {}, {place.kind, place.index}};
  }
  const Pose3& pose = polyhedron.pose;
  const Vec3 p = pose.r.inverse(a.point(0) - pose.x), dp = pose.r.inverse(a.point(1) - a.point(0));
  Closest found =
      pierces(p, dp, polyhedron.shape) ? shallowest(p, dp, polyhedron.shape) : outside(a, p, dp, polyhedron);
  found.normal = pose.r * found.normal;
  found.on_a = pose * found.on_a;
  return found;
}

}  // namespace

NearestOfSegments nearest_of_segments(const Vec3& p, const Vec3& dp, const Vec3& q, const Vec3& dq) {
  const double pp = dp.squaredNorm(), qq = dq.squaredNorm(), pq = dp.dot(dq);
  const Vec3 away = p - q, across = dp.cross(dq);
  const auto share = [](double along, double square) {
    return square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  };
  NearestOfSegments found;
  if (const double square = across.squaredNorm(); square > parallel_sine * parallel_sine * pp * qq)
    found.s = std::clamp(dq.cross(away).dot(across) / square, 0.0, 1.0);
  const double t = pq * found.s + dq.dot(away);
  found.t = share(t, qq);
  if (t <= 0 || t >= qq) found.s = share(dp.dot(q + found.t * dq - p), pp);
  return found;
}

Closest closest(const Placed3& a, const Placed3& b) {
  if (a.shape.faces.empty()) return !b.shape.faces.empty() ? with_polyhedron(a, b) : of_segments(a, b);
  Closest found = with_polyhedron(b, a);
  found.normal = -found.normal;
  found.on_a += found.distance * found.normal;
  std::swap(found.of_a, found.of_b);
  return found;
}

}  // namespace flyrock
