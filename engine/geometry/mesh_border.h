#pragma once
// The borders of a mesh: closed lines of sides that have one triangle only.

#include <array>
#include <vector>

#include "geometry/box.h"
#include "geometry/mesh.h"

namespace flyrock {

struct MeshBorder {
  std::vector<int> vertices;  ///< in the order of the triangles along it
  int triangle = 0;           ///< one of these
  Box3 box = Box3::empty();

  int edges() const { return static_cast<int>(vertices.size()); }
  /// The diagonal of its box [m].
  double size() const { return box.size().norm(); }
};

/// All borders of a mesh without faults at its edges (mesh_fault.h), in the order of their first triangles.
/// `across`: neighbours_of its triangles (mesh_edges.h).
std::vector<MeshBorder> borders_of(const Mesh& mesh, const std::vector<std::array<int, 3>>& across);

/// Takes the longest of the borders of one piece away, which is its end: the others are holes.
void take_end(std::vector<MeshBorder>& borders);

}  // namespace flyrock
