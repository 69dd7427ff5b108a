#pragma once
// Contacts with the convex edges and peaks of the ground.

#include <span>
#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"
#include "geometry/ground.h"

namespace flyrock {

/// Appends the contacts whose gap is at most `reach` [m]: edges of the polyhedron with convex edges of the
/// ground, and its faces with peaks. `facets` are those that meet `box`, the box of the polyhedron. Flat and
/// concave edges of the ground are not features. `turn` [rad]: see terrain_contacts.
void rim_contacts(const Placed3& polyhedron, int index, const Ground3& ground, std::span<const Facet> facets,
                  const Box3& box, double reach, double turn, std::vector<ContactPoint<3>>& out);

/// The same for a sphere or a pill: its ends and its axis with convex edges and peaks, in whose cones of
/// normals they lie. On the sides of these cones the facets give the contact of an end.
void core_rim_contacts(const Placed3& core, int index, const Ground3& ground, std::span<const Facet> facets,
                       double reach, double turn, std::vector<ContactPoint<3>>& out);

/// The same for a contactor with circles: the part of it that faces an edge or a peak.
void circle_rim_contacts(const Placed3& shape, int index, const Ground3& ground,
                         std::span<const Facet> facets, double reach, double turn,
                         std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
