#pragma once
// The few contacts that stand for many of one plane.

#include <span>
#include <vector>

#include "collision/contact.h"

namespace flyrock {

/// Of the contacts from index `begin` on, which share a normal, keeps at most four: the deepest, the one
/// farthest from it, and the farthest on either side of the line through these two.
void keep_four(std::vector<ContactPoint<3>>& contacts, std::size_t begin);

/// The share [m2] of points[which] in the area of the convex hull of points that lie, up to small gaps, in
/// one plane of the given normal: half of the triangles that the hull's centroid makes with its two edges. 0
/// for fewer than three points, and for one inside the hull.
double tributary_area(std::span<const Vec3> points, std::size_t which, const Vec3& normal);

}  // namespace flyrock
