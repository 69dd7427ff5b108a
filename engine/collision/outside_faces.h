#pragma once
// How far a facet of the ground is outside the faces of a polyhedron.

#include <algorithm>
#include <array>
#include <limits>

#include "collision/placed.h"

namespace flyrock {

/// The corners of a facet in the frame of a polyhedron, compared with the planes of its faces.
class OutsideFaces {
 public:
  OutsideFaces(const Placed3& polyhedron, const Placed3& facet) : shape_(polyhedron.shape) {
    for (int i = 0; i < 3; ++i) corner_[i] = polyhedron.pose.r.inverse(facet.point(i) - polyhedron.pose.x);
  }

  /// The distance of the nearest corner outside the plane of a face [m].
  double of(int face) const {
    const Vec3& normal = shape_.faces[face].normal;
    const double nearest = std::min({normal.dot(corner_[0]), normal.dot(corner_[1]), normal.dot(corner_[2])});
    return nearest - normal.dot(shape_.points[shape_.vertex(shape_.faces[face], 0)]);
  }

  /// The face outside which the facet is farthest.
  int farthest() const {
    int best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(shape_.faces.size()); ++f)
      if (const double distance = of(f); distance > most) most = distance, best = f;
    return best;
  }

 private:
  const Contactor3& shape_;
  std::array<Vec3, 3> corner_;
};

}  // namespace flyrock
