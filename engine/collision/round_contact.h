#pragma once
// The place of a convex polyhedron that is nearest to a point.

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// Where a polyhedron is nearest to a point in the world; for a point inside, the nearest of its planes.
struct NearestPlace {
  double distance = 0;          ///< m, negative inside
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the polyhedron towards the point
  FeatureKind kind = FeatureKind::face;
  int index = 0;  ///< of the vertex, edge or face
};
NearestPlace nearest_place(const Placed3& polyhedron, const Vec3& point);

}  // namespace flyrock
