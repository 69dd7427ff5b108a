#pragma once
// Outlines: contactors whose boundary is a line of segments or a mesh of triangles.
//
// An outline is a ground of its own (Contactor2::ground, Contactor3::ground), fixed or driven without spin.
// In its frame the other contactor meets it as it meets the terrain, so the rules for internal edges, rims
// and peaks are the same. Two outlines do not touch.
//
// A feature of an outline has the id of the ground (geometry/facet.h, collision/contact.h), without the index
// of a contactor: it is the only one of its body.

#include "collision/placed.h"

namespace flyrock {

/// How deep a place lies in the solid of an outline; 0 outside. In 3D it is measured upwards [m].
template <int D>
double depth_in_outline(const Placed<D>& outline, const Vec<D>& place);

}  // namespace flyrock
