#pragma once
// A convex polygon whose sides are moved inwards.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// The distance by which the sides of a counter-clockwise convex polygon can be moved inwards until the first
/// one vanishes [m]: at a corner of exterior angle a, a side loses tan(a/2) of this distance.
double greatest_inset(const std::vector<Vec2>& vertices);

/// The polygon with all sides moved inwards by less than greatest_inset. Grown by the same distance, it is
/// the given polygon with corners rounded by arcs of this radius.
std::vector<Vec2> inset(const std::vector<Vec2>& vertices, double by);

}  // namespace flyrock
