#pragma once
// Convex hulls in a plane, for example of all release positions in plan view.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// The corners of the convex hull of points, counter-clockwise, without points on its sides. One point if all
/// points are equal, two if they lie on a line, none for no points. Source: Andrew 1979, the monotone chain.
std::vector<Vec2> plan_hull(std::vector<Vec2> points);

/// The centroid of the area of a hull. For a hull without area, the midpoint of its ends; zero for no
/// corners.
Vec2 centroid_of(const std::vector<Vec2>& hull);

/// The distance [m] of a point from a hull; 0 inside it.
double distance_from(const std::vector<Vec2>& hull, const Vec2& place);

}  // namespace flyrock
