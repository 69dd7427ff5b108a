#pragma once
// What a deformable shape is made of: its form, its mesh and its elasticity.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A mesh as a file gives it, in the units of the file: triangles in 2D, tetrahedra in 3D.
template <int D>
struct GivenMesh {
  std::vector<Vec<D>> nodes;
  std::vector<std::array<int, D + 1>> cells;  ///< with a positive volume; in 2D counter-clockwise
  /// The surface of one cell: in 2D the edges of the outline, one after the other; in 3D triangles,
  /// counter-clockwise as seen from outside.
  std::vector<std::array<int, D>> sides;
  int ignored = 0;  ///< other elements of the file
};

/// More would take too long to factorise.
template <int D>
inline constexpr int most_mesh_nodes = D == 2 ? 10'000 : 2'500;

enum class DeformableForm {
  rectangle,  ///< in 2D
  disk,       ///< in 2D
  box,        ///< in 3D
  mesh
};

/// SI units. The density and the thickness in 2D are those of the body.
template <int D>
struct Deformable {
  DeformableForm form = DeformableForm::mesh;
  Vec<D> size = Vec<D>::Zero();              ///< m, of a rectangle or box
  std::array<int, D> cells{};                ///< quads or bricks along each side of it
  double radius = 0;                         ///< m, of a disk
  int rings = 0;                             ///< of a disk
  std::shared_ptr<const GivenMesh<D>> mesh;  ///< of the form `mesh`
  double scale = 1;                          ///< m per unit of it
  double young = 0;                          ///< Pa
  double poisson = 0;
  double alpha = 0;                        ///< 1/s, damping in proportion to the mass
  double beta = 0;                         ///< s, damping in proportion to the stiffness
  std::optional<double> tensile_strength;  ///< Pa
};

}  // namespace flyrock
