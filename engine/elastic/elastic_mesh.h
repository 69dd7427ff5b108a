#pragma once
// Meshes of deformable blocks: triangles whose corners are the nodes.

#include <array>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// The mesh of a body in the frame in which its form is given [m].
template <int D>
struct ElasticMesh {
  std::vector<Vec<D>> nodes;
  std::vector<std::array<int, D + 1>> cells;  ///< nodes of each cell; in 2D counter-clockwise
  std::vector<int> surface;                   ///< nodes on the surface; in 2D counter-clockwise
  int ignored = 0;                            ///< elements of its file that are not among the cells
};

/// A rectangle about the origin. Its quads are crossed: each is four triangles about its middle, because a
/// mesh with one diagonal is stiffer along it (of a cantilever of 4 cells 0.82 of the sag, crossed 0.95).
/// `cells`: quads along each side.
ElasticMesh<2> crossed_rectangle(const Vec2& size, const std::array<int, 2>& cells);

/// A disk about the origin: ring k of nodes has the radius k R / rings and 6 k nodes.
ElasticMesh<2> ringed_disk(double radius, int rings);

/// Area, centre and polar moment about the centre of the cells [m2, m, m4], exact.
struct MeshSection {
  double area = 0;
  Vec2 centre = Vec2::Zero();
  double polar_moment = 0;
};
MeshSection section_of(const ElasticMesh<2>& mesh);

/// Twice the area of a cell [m2]; not positive of an inverted one.
double doubled_cell_area(const ElasticMesh<2>& mesh, const std::array<int, 3>& cell);

}  // namespace flyrock
