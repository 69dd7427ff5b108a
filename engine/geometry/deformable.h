#pragma once
// What a deformable shape is made of: its form, its mesh and its elasticity.

#include <array>
#include <optional>

#include "math/space.h"

namespace flyrock {

/// In 2D; SI units. The density and the thickness are those of the body.
struct Deformable {
  enum class Form { rectangle, disk };
  Form form = Form::rectangle;
  Vec2 size = Vec2::Zero();    ///< m, of a rectangle
  std::array<int, 2> cells{};  ///< quads along each side of a rectangle
  double radius = 0;           ///< m, of a disk
  int rings = 0;               ///< of a disk
  double young = 0;            ///< Pa
  double poisson = 0;
  double alpha = 0;                        ///< 1/s, damping in proportion to the mass
  double beta = 0;                         ///< s, damping in proportion to the stiffness
  std::optional<double> tensile_strength;  ///< Pa
};

}  // namespace flyrock
