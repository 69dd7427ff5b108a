#pragma once
// Contacts of two contactors of moving bodies.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// Appends the contacts of two disks or convex polygons whose gap is at most `reach` [m], at most two.
/// Polygons: the axis of greatest separation among the normals of both decides; the edge that faces it is clipped to
/// the strip of the reference edge. A disk and a polygon: nearest edge or vertex.
void body_contacts(const Placed2& candidate, int candidate_index, const Placed2& antagonist, int antagonist_index,
                   double reach, std::vector<ContactPoint<2>>& out);

}  // namespace flyrock
