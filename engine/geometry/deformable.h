#pragma once
// What a deformable shape is made of: its form, its mesh and its elasticity.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A mesh of triangles as a file gives it, in the units of the file.
struct GivenMesh {
  std::vector<Vec2> nodes;
  std::vector<std::array<int, 3>> cells;  ///< counter-clockwise
  std::vector<int> outline;               ///< nodes of the only outline, counter-clockwise
  int ignored = 0;                        ///< other elements of the file
};

/// In 2D; SI units. The density and the thickness are those of the body.
struct Deformable {
  enum class Form { rectangle, disk, mesh };
  Form form = Form::rectangle;
  Vec2 size = Vec2::Zero();               ///< m, of a rectangle
  std::array<int, 2> cells{};             ///< quads along each side of a rectangle
  double radius = 0;                      ///< m, of a disk
  int rings = 0;                          ///< of a disk
  std::shared_ptr<const GivenMesh> mesh;  ///< of the form `mesh`
  double scale = 1;                       ///< m per unit of it
  double young = 0;                       ///< Pa
  double poisson = 0;
  double alpha = 0;                        ///< 1/s, damping in proportion to the mass
  double beta = 0;                         ///< s, damping in proportion to the stiffness
  std::optional<double> tensile_strength;  ///< Pa
};

}  // namespace flyrock
