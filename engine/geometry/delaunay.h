#pragma once
// The triangulation of points in a plane in which no circle about a triangle holds another point (Delaunay).

#include <array>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Triangles as indices into the points, counter-clockwise, by Qhull. Points at the same place are one of
/// them. Throws std::invalid_argument if there are fewer than three points, or all lie in a line.
std::vector<std::array<int, 3>> delaunay(const std::vector<Vec2>& points);

}  // namespace flyrock
