#pragma once
// The point of a convex polyhedron that is nearest to a given point.

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// The feature of a polyhedron that is nearest to a point in the world. For a point inside, the nearest face
/// plane.
struct NearestPlace {
  double distance = 0;          ///< m, negative inside
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the polyhedron towards the point
  FeatureKind kind = FeatureKind::face;
  int index = 0;  ///< of the vertex, edge or face
};
NearestPlace nearest_place(const Placed3& polyhedron, const Vec3& point);

}  // namespace flyrock
