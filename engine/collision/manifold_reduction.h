#pragma once
// Reduction of the contacts of one plane to a few, and the area that each contact represents.

#include <span>
#include <vector>

#include "collision/contact.h"

namespace flyrock {

/// Reduces the contacts from index `begin` on, which share a normal, to at most four: the deepest one, the
/// one farthest from it, and the farthest one on either side of the line through these two. The area of the
/// convex hull that gets lost is shared by those that stay (ContactPoint::dropped_area).
void keep_four(std::vector<ContactPoint<3>>& contacts, std::size_t begin);

/// The tributary area of points[which] [m2]: its share of the area of the convex hull of points that lie, up
/// to small gaps, in one plane with the given normal. It is half of the two triangles between the hull's
/// centroid and the two edges at the point. 0 for fewer than three points, and for a point inside the hull.
double tributary_area(std::span<const Vec3> points, std::size_t which, const Vec3& normal);

}  // namespace flyrock
