#pragma once
// Contacts of two contactors of moving bodies.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// Appends the contacts of two disks or convex polygons whose gap is at most `reach` [m], at most two.
/// Polygons: the axis of greatest separation among the normals of both decides; the edge that faces it is
/// clipped to the strip of the reference edge. A disk and a polygon: nearest edge or vertex.
void body_contacts(const Placed2& candidate, int candidate_index, const Placed2& antagonist,
                   int antagonist_index, double reach, std::vector<ContactPoint<2>>& out);

/// Appends the contacts of two spheres or convex polyhedra whose gap is at most `reach` [m].
/// A sphere and a polyhedron: the nearest place of its faces, edges and vertices. Polyhedra: the axis of
/// greatest separation among the normals of both and the products of two edges decides (the separating axis
/// theorem). A face: the face of the other that is turned to it is clipped to its sides, at most four
/// contacts. Two edges: one contact.
void body_contacts(const Placed3& candidate, int candidate_index, const Placed3& antagonist,
                   int antagonist_index, double reach, std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
