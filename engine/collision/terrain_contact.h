#pragma once
// Contact points of one contactor with the terrain.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"
#include "geometry/ground.h"
#include "geometry/ground2.h"

namespace flyrock {

/// A vertex that is less deep than this share of the size touches each segment, or facet, that it lies below.
/// A deeper vertex, which only fixed time steps produce, is pushed out to the nearest place. At a concave
/// corner or rim, the strip over a segment or facet is longer by as much.
inline constexpr double shallow_share = 1e-3;

/// Appends the contacts of a hull, grown by its radius, with the terrain whose gap is at most `reach` [m].
///
/// Each vertex meets the segments whose strips contain it. A convex corner meets the edge that it faces, if
/// the normal of the edge lies in the cone of normals of the corner; beyond the ends of this edge, and of a
/// disk, it meets the vertex, if the radius is not 0 and the vertex lies in the cone. Flat and concave
/// corners are not features, so that internal edges are not felt. A vertex deep below the ground, which only
/// fixed time steps produce, is pushed out to the nearest point of the polyline. `contactor_index` is part of
/// the feature ids. `turn` [rad] is the rotation of the body since a state without penetration, because
/// contacts are detected in the middle of a step. An edge that has left a corner's cone by at most this angle
/// is still held.
void terrain_contacts(const Placed2& contactor, int contactor_index, const Ground2& ground, double reach,
                      double turn, std::vector<ContactPoint<2>>& out);

/// The same in 3D. A sphere meets each facet in whose strip its centre lies, and each convex edge and peak in
/// whose cone of normals it lies. The ends of a pill are spheres; its edge meets convex edges and peaks.
/// A polyhedron meets facets with its vertices, convex edges with its edges, and peaks with its faces. Of the
/// contacts in one plane, at most four are kept (contact_patch.h).
void terrain_contacts(const Placed3& contactor, int contactor_index, const Ground3& ground, double reach,
                      double turn, std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
