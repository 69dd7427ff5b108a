#pragma once
// Meshes of deformable blocks: triangles or tetrahedra whose corners are the nodes.

#include <array>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// The mesh of a body in the frame in which its form is given [m]: triangles in 2D, tetrahedra in 3D.
template <int D>
struct ElasticMesh {
  using Cell = std::array<int, D + 1>;
  using Side = std::array<int, D>;

  std::vector<Vec<D>> nodes;
  std::vector<Cell> cells;   ///< nodes of each cell, so that its volume is positive; in 2D counter-clockwise
  std::vector<int> surface;  ///< nodes on the surface; in 2D counter-clockwise, in 3D by number
  int ignored = 0;           ///< elements of its file that are not among the cells
  std::vector<Side> sides = {};  ///< outer_sides of the cells
};

/// The sides that only one cell has, in the order of the cells: edges from node to node in 2D, triangles that
/// are counter-clockwise as seen from outside in 3D.
template <int D>
std::vector<std::array<int, D>> outer_sides(const std::vector<std::array<int, D + 1>>& cells);
/// Sets the sides of a mesh, and in 3D the nodes of its surface.
template <int D>
void find_surface(ElasticMesh<D>& mesh);

/// A rectangle about the origin. Its quads are crossed: each is four triangles about its middle, because a
/// mesh with one diagonal is stiffer along it (of a cantilever of 4 cells 0.82 of the sag, crossed 0.95).
/// `cells`: quads along each side.
ElasticMesh<2> crossed_rectangle(const Vec2& size, const std::array<int, 2>& cells);

/// A disk about the origin: ring k of nodes has the radius k R / rings and 6 k nodes.
ElasticMesh<2> ringed_disk(double radius, int rings);

/// A box about the origin. Each of its bricks is five tetrahedra, one of them between four corners of which
/// no two share an edge; bricks that are neighbours are mirror images, so that no diagonal is preferred: the
/// pattern goes over into itself by all turns and mirrors of the cube (about a corner of a brick), and with
/// even numbers of bricks so does the box. `cells`: bricks along each side.
ElasticMesh<3> bricked_box(const Vec3& size, const std::array<int, 3>& cells);

/// Volume, centre and second moments of the cells, exact. In 2D the volume is an area.
template <int D>
struct MeshMoments {
  double volume = 0;  ///< m^D
  Vec<D> centre = Vec<D>::Zero();
  Eigen::Matrix<double, D, D> spread = Eigen::Matrix<double, D, D>::Zero();  ///< of r r^T, r from the centre
};
template <int D>
MeshMoments<D> moments_of(const ElasticMesh<D>& mesh);

/// D! times the volume of a cell [m^D]; not positive of an inverted one.
double cell_determinant(const ElasticMesh<2>& mesh, const std::array<int, 3>& cell);
double cell_determinant(const ElasticMesh<3>& mesh, const std::array<int, 4>& cell);

/// The volume of a cell [m^D].
template <int D>
double cell_volume(const ElasticMesh<D>& mesh, const std::array<int, D + 1>& cell) {
  return cell_determinant(mesh, cell) / (D == 2 ? 2 : 6);
}

}  // namespace flyrock
