#pragma once
// Contacts of one contactor with the terrain.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"
#include "collision/terrain.h"
#include "collision/terrain3.h"

namespace flyrock {

/// Appends the contacts of a disk or convex polygon with the terrain whose gap is at most `reach` [m].
///
/// A disk meets each segment whose strip holds its centre, and each convex corner in whose cone of normals it
/// lies. A polygon meets segments with its vertices and convex corners with its edges. Flat and concave
/// corners are no features: internal edges are not felt. A vertex deep below the ground, as only fixed time
/// steps produce, is pushed out to the nearest place of the poly-line.
/// `contactor_index` is part of the feature ids. `turn` [rad]: how far the body is turned on from a state
/// without overlap, as it is in the middle of a step; an edge that has turned out of a corner's cone by no
/// more is still held.
void terrain_contacts(const Placed2& contactor, int contactor_index, const Terrain2& terrain, double reach,
                      double turn, std::vector<ContactPoint<2>>& out);

/// Appends the contacts of a sphere or convex polyhedron with a plane whose gap is at most `reach` [m]: of a
/// polyhedron its vertices, at most four.
void terrain_contacts(const Placed3& contactor, int contactor_index, const Terrain3& terrain, double reach,
                      std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
