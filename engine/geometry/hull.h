#pragma once
// Convex hulls in 3D.

#include "geometry/contactor3.h"

namespace flyrock {

/// The convex hull of points, by Qhull. Faces in one plane are merged; points inside are left out. Throws
/// std::invalid_argument if there are fewer than four points or all lie in one plane.
Contactor3 convex_hull(const std::vector<Vec3>& points);

}  // namespace flyrock
