#pragma once
// A contactor at its pose in the world.

#include "collision/contact.h"
#include "geometry/box.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

struct Pose2 {
  Vec2 x = Vec2::Zero();
  Rotation2 r;

  Vec2 operator*(const Vec2& local) const { return x + r * local; }
};

/// A view of a contactor, which must outlive it.
template <int D>
struct Placed;
using Placed2 = Placed<2>;
using Placed3 = Placed<3>;

template <>
struct Placed<2> {
  const Contactor2& shape;
  Pose2 pose;
  int index = 0;  ///< of the contactor in its body, for feature ids

  FeatureId vertex(int i) const { return vertex_id(index, i); }
  FeatureId edge(int i) const { return edge_id(index, i); }
  int count() const { return static_cast<int>(shape.points.size()); }
  Vec2 point(int i) const { return pose * shape.points[i]; }
  Vec2 normal(int edge) const { return pose.r * shape.normals[edge]; }
  /// Distance of a point from the line of an edge, positive outside.
  double outside(int edge, const Vec2& world) const {
    return shape.normals[edge].dot(pose.r.inverse(world - pose.x) - shape.points[edge]);
  }
};

struct Pose3 {
  Vec3 x = Vec3::Zero();
  Rotation3 r;

  Vec3 operator*(const Vec3& local) const { return x + r * local; }
};

template <>
struct Placed<3> {
  const Contactor3& shape;
  Pose3 pose;
  int index = 0;

  FeatureId id(const ShapeFeature& feature) const { return feature_id(index, feature.kind, feature.index); }
  int count() const { return static_cast<int>(shape.points.size()); }
  int faces() const { return static_cast<int>(shape.faces.size()); }
  Vec3 point(int i) const { return pose * shape.points[i]; }
  /// The place of the core that is farthest along a direction.
  Vec3 support(const Vec3& direction) const { return pose * shape.support(pose.r.inverse(direction)); }
  Vec3 normal(int face) const { return pose.r * shape.faces[face].normal; }
  /// A vertex of a face's loop.
  Vec3 corner(int face, int i) const { return point(shape.vertex(shape.faces[face], i)); }
  /// Distance of a point from the plane of a face, positive outside.
  double outside(int face, const Vec3& world) const {
    const Contactor3::Face& f = shape.faces[face];
    return f.normal.dot(pose.r.inverse(world - pose.x) - shape.points[shape.vertex(f, 0)]);
  }
};

template <int D>
Box<D> box_of_points(const Placed<D>& placed) {
  const Vec<D> first = placed.point(0);
  Box<D> box{first, first};
  for (int i = 1; i < placed.count(); ++i) box.add(placed.point(i));
  return box;
}
/// The box of the core, without its radius. A half space is everywhere.
inline Box2 core_box(const Placed2& placed) { return box_of_points(placed); }
inline Box3 core_box(const Placed3& placed) {
  const Contactor3& shape = placed.shape;
  if (shape.form == Form::half_space) return {Vec3::Constant(-shape.bound), Vec3::Constant(shape.bound)};
  if (shape.circles.empty()) return box_of_points(placed);
  Box3 box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = placed.support(-Vec3::Unit(k))[k];
    box.high[k] = placed.support(Vec3::Unit(k))[k];
  }
  return box;
}

}  // namespace flyrock
