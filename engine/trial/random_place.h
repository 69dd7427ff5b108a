#pragma once
// Uniformly random places.

#include <vector>

#include "math/space.h"
#include "random/stream.h"

namespace flyrock {

/// Uniform along a polyline.
Vec3 random_along(const std::vector<Vec3>& points, RandomStream& rng);

/// Uniform in a flat convex polygon.
Vec3 random_inside(const std::vector<Vec3>& points, RandomStream& rng);

}  // namespace flyrock
