#include "collision/hull/separating_axis.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {
constexpr double minus_infinity = -std::numeric_limits<double>::infinity();
// Edges whose angle has a smaller sine than this are parallel. A face axis then separates equally well.
constexpr double least_sine = 1e-6;
constexpr double rounding_share = 1e-9;  // of the sizes

/// A ball inside a polyhedron, in its frame.
struct InnerBall {
  Vec3 centre;
  double radius = 0;
};
InnerBall inner_ball(const Contactor3& shape) {
  InnerBall ball{Vec3::Zero(), std::numeric_limits<double>::infinity()};
  for (const Vec3& p : shape.points) ball.centre += p;
  ball.centre /= static_cast<double>(shape.points.size());
  for (const Contactor3::Face& face : shape.faces)
    ball.radius = std::min(ball.radius, face.normal.dot(shape.points[shape.vertex(face, 0)] - ball.centre));
  return ball;
}

/// The edges whose arcs of normals come so near to the direction of `d` that n . d >= need somewhere on them.
using Edges = boost::container::small_vector<int, 128>;
Edges edges_towards(const Contactor3& shape, const Vec3& d, double need) {
  Edges near;
  for (int i = 0; i < static_cast<int>(shape.edges.size()); ++i) {
    const Contactor3::Edge& edge = shape.edges[i];
    const Vec3 &left = shape.faces[edge.left].normal, &right = shape.faces[edge.right].normal;
    const double l = left.dot(d), r = right.dot(d), cosine = left.dot(right);
    double most = std::max(l, r);
    if (r > cosine * l && l > cosine * r) {  // the greatest is between the two ends of the arc
      const Vec3 along = shape.points[edge.end] - shape.points[edge.start];
      const double part = along.dot(d);
      most = std::sqrt(std::max(0.0, d.squaredNorm() - part * part / along.squaredNorm()));
    }
    if (!(most < need)) near.push_back(i);
  }
  return near;
}
}  // namespace

FaceAxis best_face_axis(const Placed3& reference, const Placed3& other) {
  FaceAxis best{0, minus_infinity};
  const Vec3 away = reference.pose.r.inverse(other.pose.x - reference.pose.x);
  const InnerBall ball = inner_ball(other.shape);
  const Vec3 centre = away + reference.pose.r.inverse(other.pose.r * ball.centre);
  const double radius = ball.radius - rounding_share * (reference.shape.bound + other.shape.bound);
  const auto height = [&](int f, const Vec3& point) {
    const Contactor3::Face& face = reference.shape.faces[f];
    return face.normal.dot(point - reference.shape.points[reference.shape.vertex(face, 0)]);
  };
  const auto consider = [&](int f) {
    const Contactor3::Face& face = reference.shape.faces[f];
    const Vec3 axis = other.pose.r.inverse(reference.normal(f));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& p : other.shape.points) nearest = std::min(nearest, axis.dot(p));
    const Vec3& on_face = reference.shape.points[reference.shape.vertex(face, 0)];
    const double separation = nearest + face.normal.dot(away - on_face);
    if (separation > best.separation || (separation == best.separation && f < best.face))
      best = {f, separation};
  };
  // The face from whose plane the ball is furthest, then those that may separate more
  int furthest = 0;
  for (int f = 1; f < reference.faces(); ++f)
    if (height(f, centre) > height(furthest, centre)) furthest = f;
  consider(furthest);
  for (int f = 0; f < reference.faces(); ++f)
    if (f != furthest && height(f, centre) - radius >= best.separation) consider(f);
  return best;
}

EdgeAxis best_edge_axis(const Placed3& a, const Placed3& b, double least) {
  EdgeAxis best;
  best.separation = minus_infinity;
  const auto& of_a = a.shape;
  // From the frame of b to the frame of a, in which everything is computed
  const Rotation3 r = a.pose.r.inverse() * b.pose.r;
  const Vec3 x = a.pose.r.inverse(b.pose.x - a.pose.x);
  double need = least;
  Vec3 d = Vec3::Zero();
  if (std::isfinite(least)) {
    const InnerBall in_a = inner_ball(of_a), in_b = inner_ball(b.shape);
    d = x + r * in_b.centre - in_a.centre;
    need += in_a.radius + in_b.radius - rounding_share * (of_a.bound + b.shape.bound);
  }
  const Edges near_a = edges_towards(of_a, d, need), near_b = edges_towards(b.shape, -r.inverse(d), need);
  for (const int j : near_b) {
    const Contactor3::Edge& edge = b.shape.edges[j];
    const Vec3 start = x + r * b.shape.points[edge.start];
    const Vec3 along = x + r * b.shape.points[edge.end] - start;
    const Vec3 left = -(r * b.shape.faces[edge.left].normal), right = -(r * b.shape.faces[edge.right].normal);
    for (const int i : near_a) {
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
