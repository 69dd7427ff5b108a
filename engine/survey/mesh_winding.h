#pragma once
// One side for the triangles of a mesh whose file does not say which side is the outer one.

#include "geometry/mesh.h"

namespace flyrock {

/// Turns triangles so that neighbours across an edge run along it in opposite directions; then a piece with a
/// border as a whole so that it looks up, and a closed piece so that it looks outwards. Overhangs keep the
/// side of the ground about them. Equal places must be one vertex (join_equal_places). Pieces that cannot
/// have one side (a Moebius strip) are left to the faults of the mesh.
void wind_alike(Mesh& mesh);

}  // namespace flyrock
