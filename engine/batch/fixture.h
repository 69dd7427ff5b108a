#pragma once
// Fixed and driven bodies of a trial, which pictures of the motion show beside the rocks.

#include <array>
#include <string>

#include "batch/rock_surface.h"
#include "world/observe.h"
#include "world/world.h"

namespace flyrock {

/// A body whose motion is prescribed: at rest, or, at the time t after the start,
///   x = x_0 + v t + a t^2 / 2,  R = exp(t w) R_0
/// in the frame of the world, with the velocity v and the spin w of `start`.
struct Fixture {
  std::string body;
  BodyState start;
  std::array<double, 4> turn = {1, 0, 0, 0};  ///< 3D: attitude R_0, as in TrajectoryPoint
  Vec3 acceleration = Vec3::Zero();           ///< m/s2, a
};

/// A corner of the surface of a fixture, in the frame of the body.
struct FixtureCorner {
  std::string body;
  SurfaceCorner corner;
};

/// A body that is not dynamic, at its start. Instantiated for D = 2, 3.
template <int D>
Fixture fixture_of(const World<D>& world, const Body<D>& body);

}  // namespace flyrock
