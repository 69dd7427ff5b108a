#pragma once
// The cone.

#include "geometry/contactor3.h"

namespace flyrock {

/// The hull of a circle and a point on its axis, z. The origin is the centre of mass, a quarter of the height
/// above the base; the point is up.
Contactor3 cone(double radius, double height);

}  // namespace flyrock
