#pragma once
// The ground of a 3D run, which is one plane.

#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// An unbounded plane. The ground lies on the side opposite to the unit normal, which points upwards
/// (normal.z > 0).
struct Plane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  std::vector<std::string> parts = {""};  ///< one

  /// z of the ground at (x, y).
  double height(double x, double y) const {
    return point.z() - (normal.x() * (x - point.x()) + normal.y() * (y - point.y())) / normal.z();
  }
  double distance(const Vec3& p) const { return normal.dot(p - point); }
};

}  // namespace flyrock
