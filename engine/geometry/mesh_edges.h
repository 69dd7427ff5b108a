#pragma once
// How the triangles of a mesh meet at their edges.

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// One side of a triangle: from its corner `side` to the next corner. `low` and `high` are the vertices of
/// the edge in the order of their indices; `forward` tells whether the triangle runs from low to high.
struct MeshSide {
  int low = 0, high = 0;
  int triangle = 0, side = 0;
  bool forward = true;

  bool same_edge(const MeshSide& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles; those of one edge follow each other, in the order of their triangles.
std::vector<MeshSide> sorted_sides(const std::vector<std::array<int, 3>>& triangles);

/// Calls use(begin, end) with the sides of each edge.
template <class Use>
void for_edges(const std::vector<MeshSide>& sides, Use use) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i; end < sides.size() && sides[end].same_edge(sides[i]); ++end) {
    }
    use(i, end);
  }
}

/// neighbours[t][k]: the triangle across side k of triangle t; -1 at the border. An edge of more than two
/// triangles pairs the first two of them; see mesh_fault.h.
std::vector<std::array<int, 3>> neighbours_of(const std::vector<std::array<int, 3>>& triangles,
                                              const std::vector<MeshSide>& sides);

/// Gives equal places one vertex, the first of them. Other vertices stay, without a triangle.
void join_equal_places(Mesh& mesh);

/// The mesh with equal places joined into one vertex: triangles of files that repeat their corners meet at
/// edges only afterwards. A vertex where several fans of triangles meet without a common edge is repeated,
/// one for each fan, so that the triangles about a vertex always are one fan. Vertices without a triangle
/// are dropped.
Mesh welded(Mesh mesh);

}  // namespace flyrock
