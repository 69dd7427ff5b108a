#pragma once
// The sphere with the volume of a rock of any shape.

#include <cmath>

#include "math/space.h"

namespace flyrock {

/// The radius [m] of the sphere of a volume [m3].
inline double sphere_radius(double volume) { return std::cbrt(3 * volume / (4 * pi)); }

}  // namespace flyrock
