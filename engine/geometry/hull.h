#pragma once
// Convex hulls in space.

#include "geometry/contactor3.h"

namespace flyrock {

/// The convex hull of points, by Qhull; faces that lie in one plane are one. Points inside are left out.
/// Throws std::invalid_argument where the points are fewer than four or lie in one plane.
Contactor3 convex_hull(const std::vector<Vec3>& points);

}  // namespace flyrock
