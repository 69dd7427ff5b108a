#pragma once
// What makes a mesh no ground.

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// What is wrong with a mesh as a ground, with places in the coordinates of the mesh; empty if nothing is.
/// Refused are, in this order: no triangles, indices that do not exist, coordinates that are not finite,
/// triangles without an area, an edge of more than two triangles, neighbours that face opposite ways, a
/// connected piece that faces down (a closed one: inwards), and holes inside of a piece. A piece may have
/// one border, which is its end.
/// `lines`: the line of a file that each triangle stands in, for the text; may be empty. The mesh must be
/// `welded` (mesh_edges.h).
std::string fault(const Mesh& mesh, const std::vector<int>& lines = {});

}  // namespace flyrock
