#pragma once
// Narrow phase: the contact points of two contactors of moving bodies.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// Appends the contacts of two hulls whose gap is at most `reach` [m], at most two. If one of them has a
/// radius, the contact is at the nearest edge or vertex of their cores; edges that lie flush have a second
/// one at the other end of what is common. For two sharp polygons, the reference edge is the edge whose
/// normal separates them most. The incident edge, which faces it, is clipped to the strip of the reference
/// edge. Rooms and surfaces have rules of their own (room.h, surface.h). `turn` [rad]: the rotation of the
/// bodies since a state without penetration, as in terrain_contacts.
void body_contacts(const Placed2& candidate, int candidate_index, const Placed2& antagonist,
                   int antagonist_index, double reach, std::vector<ContactPoint<2>>& out, double turn = 0);

/// Appends the contacts of two spheres, pills or convex polyhedra whose gap is at most `reach` [m].
/// With a sphere or a pill, the contact is at the nearest vertices, edges and faces of the two cores
/// (closest.h). A pill that lies flush on an edge or a face has two contacts, at the ends of the common line.
/// For two polyhedra, the axis of greatest separation is found among the face normals of both and the cross
/// products of two edges (separating axis theorem). If it is a face normal, the incident face of the other
/// polyhedron is clipped to the sides of this reference face: at most four contact points. If it belongs to
/// two edges: one contact point.
void body_contacts(const Placed3& candidate, int candidate_index, const Placed3& antagonist,
                   int antagonist_index, double reach, std::vector<ContactPoint<3>>& out, double turn = 0);

}  // namespace flyrock
