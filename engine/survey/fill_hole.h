#pragma once
// The holes of a mesh, and triangles that fill them.

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// The borders inside of the pieces of a mesh without other faults (mesh_fault.h), as vertices in the order
/// of the triangles along them. The longest border of a piece is its end, and no hole.
std::vector<std::vector<int>> holes_of(const Mesh& mesh);

/// The triangles of least total area that fill a border, facing as those along it. Source: Barequet, G.,
/// Sharir, M. (1995): Filling gaps in the boundary of a polyhedron. Computer Aided Geometric Design 12.
std::vector<std::array<int, 3>> fill_hole(const std::vector<Vec3>& vertices, const std::vector<int>& border);

}  // namespace flyrock
