#pragma once
// Rotations in 3D that a scenario gives by four numbers.

#include <span>

#include "math/space.h"

namespace flyrock {

/// The rotation of a quaternion [w, x, y, z] of any length, or, if `about_axis`, about the axis [x, y, z] of
/// any length by an angle [rad], the fourth number. Throws StartError for a quaternion or an axis of length
/// 0, which a distribution may draw.
Rotation3 turn_of(std::span<const double, 4> numbers, bool about_axis);

}  // namespace flyrock
