#pragma once
// Convex hulls in a plane, such as that of all release places in plan.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// The corners of the convex hull of points, counter-clockwise, those within its sides left out: a point
/// alone where all are the same, two where they lie in a line, none of none. Source: Andrew 1979, the
/// monotone chain.
std::vector<Vec2> plan_hull(std::vector<Vec2> points);

/// The centroid of the area of a hull; of a hull that has none the middle of its ends. Zero of no corners.
Vec2 centroid_of(const std::vector<Vec2>& hull);

/// How far a place is from a hull, 0 within it.
double distance_from(const std::vector<Vec2>& hull, const Vec2& place);

}  // namespace flyrock
