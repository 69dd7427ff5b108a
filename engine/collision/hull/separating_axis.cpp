#include "collision/hull/separating_axis.h"

#include <algorithm>
#include <limits>

namespace flyrock {

namespace {
constexpr double minus_infinity = -std::numeric_limits<double>::infinity();
// Edges whose angle has a smaller sine than this are parallel. A face axis then separates equally well.
constexpr double least_sine = 1e-6;
}  // namespace

FaceAxis best_face_axis(const Placed3& reference, const Placed3& other) {
  FaceAxis best{0, minus_infinity};
  const Vec3 away = reference.pose.r.inverse(other.pose.x - reference.pose.x);
  for (int f = 0; f < reference.faces(); ++f) {
    const Contactor3::Face& face = reference.shape.faces[f];
    const Vec3 axis = other.pose.r.inverse(reference.normal(f));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& p : other.shape.points) nearest = std::min(nearest, axis.dot(p));
    const Vec3& on_face = reference.shape.points[reference.shape.vertex(face, 0)];
    const double separation = nearest + face.normal.dot(away - on_face);
    if (separation > best.separation) best = {f, separation};
  }
  return best;
}

EdgeAxis best_edge_axis(const Placed3& a, const Placed3& b) {
  EdgeAxis best;
  best.separation = minus_infinity;
  const auto& of_a = a.shape;
  // From the frame of b to the frame of a, in which everything is computed
  const Rotation3 r = a.pose.r.inverse() * b.pose.r;
  const Vec3 x = a.pose.r.inverse(b.pose.x - a.pose.x);
  for (int j = 0; j < static_cast<int>(b.shape.edges.size()); ++j) {
    const Contactor3::Edge& edge = b.shape.edges[j];
    const Vec3 start = x + r * b.shape.points[edge.start];
    const Vec3 along = x + r * b.shape.points[edge.end] - start;
    const Vec3 left = -(r * b.shape.faces[edge.left].normal), right = -(r * b.shape.faces[edge.right].normal);
    for (int i = 0; i < static_cast<int>(of_a.edges.size()); ++i) {
      const Contactor3::Edge& mine = of_a.edges[i];
      const Vec3& from = of_a.points[mine.start];
      const Vec3 direction = of_a.points[mine.end] - from;
      const double l = left.dot(direction), k = right.dot(direction);
      if (l * k >= 0) continue;
      const Vec3 &mine_left = of_a.faces[mine.left].normal, &mine_right = of_a.faces[mine.right].normal;
      const double p = mine_left.dot(along), q = mine_right.dot(along);
      if (p * q >= 0 || l * q <= 0) continue;
      Vec3 normal = direction.cross(along);
      const double length = normal.norm();
      if (length <= least_sine * direction.norm() * along.norm()) continue;
      normal /= normal.dot(mine_left + mine_right) < 0 ? -length : length;
      if (const double separation = normal.dot(start - from); separation > best.separation)
        best = {i, j, normal, separation};
    }
  }
  best.normal = a.pose.r * best.normal;
  return best;
}

}  // namespace flyrock
