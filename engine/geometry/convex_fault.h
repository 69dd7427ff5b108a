#pragma once
// What makes a surface of triangles no convex polyhedron.

#include <string>
#include <vector>

#include "geometry/contactor3.h"
#include "geometry/mesh.h"

namespace flyrock {

/// Why the triangles of a mesh (`welded`, mesh_edges.h) are not the surface of their convex hull `hull`, with
/// places in the coordinates of the mesh; empty if they are. Refused are, in this order: a triangle without
/// an area, an edge that is not the edge of two triangles of opposite directions, a surface that faces
/// inwards, a vertex inside of the hull by more than 1e-6 of its size, a volume below that of the hull by
/// more than 1e-5 (a dent without a vertex, or several pieces). `lines`: the line of a file that each
/// triangle stands in, for the text; may be empty.
std::string convex_fault(const Mesh& mesh, const Contactor3& hull, const std::vector<int>& lines = {});

}  // namespace flyrock
