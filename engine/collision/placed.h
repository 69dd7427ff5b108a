#pragma once
// A contactor at its place in the world.

#include "geometry/contactor.h"

namespace flyrock {

struct Pose2 {
  Vec2 x = Vec2::Zero();
  Rotation2 r;

  Vec2 operator*(const Vec2& local) const { return x + r * local; }
};

/// A view of a contactor, which must outlive it.
struct Placed2 {
  const Contactor2& shape;
  Pose2 pose;

  int count() const { return static_cast<int>(shape.points.size()); }
  Vec2 point(int i) const { return pose * shape.points[i]; }
  Vec2 normal(int edge) const { return pose.r * shape.normals[edge]; }
  /// Distance of a point from the line of an edge, positive outside.
  double outside(int edge, const Vec2& world) const {
    return shape.normals[edge].dot(pose.r.inverse(world - pose.x) - shape.points[edge]);
  }
};

}  // namespace flyrock
