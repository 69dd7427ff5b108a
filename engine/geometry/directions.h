#pragma once
// Random directions about a mean direction.

#include "math/space.h"
#include "random/stream.h"

namespace flyrock {

/// A unit vector with the distribution of von Mises and Fisher, whose density is as exp(k mean.x): Fisher's
/// on the sphere, von Mises' on the circle. `mean` is a unit vector, k above 0.
///   3D: cos(angle) = 1 + ln(1 - u (1 - exp(-2 k))) / k  (E cos = coth k - 1/k)
///   2D: by rejection, D. J. Best and N. I. Fisher, Applied Statistics 28, 1979.
Vec2 fisher_direction(const Vec2& mean, double k, RandomStream& rng);
Vec3 fisher_direction(const Vec3& mean, double k, RandomStream& rng);

}  // namespace flyrock
