#pragma once
// Convex hulls in 3D.

#include "geometry/contactor3.h"

namespace flyrock {

/// The convex hull of points, by Qhull. Faces in one plane are merged; points inside are left out. Throws
/// std::invalid_argument if there are fewer than four points or all lie in one plane.
Contactor3 convex_hull(const std::vector<Vec3>& points);

/// A norm block (EOTA): the hull of the points (+-1/2, +-1/4, +-1/4) and their permutations, with each axis
/// scaled by a side [m]. It has 24 vertices, 26 faces and 17/24 of the volume of its bounding box.
Contactor3 norm_block(const Vec3& sides);

}  // namespace flyrock
