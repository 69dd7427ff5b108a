#pragma once
// The area that a disc and a polygon share.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// The common area of the disc of a radius about `centre` and a polygon, counter-clockwise [m2]. The sum over
/// the edges of the signed area of the triangle (centre, a, b) inside the disc.
double disc_overlap(const std::vector<Vec2>& polygon, const Vec2& centre, double radius);

}  // namespace flyrock
