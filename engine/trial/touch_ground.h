#pragma once
// Brings a body to the ground.

#include <optional>

#include "world/body.h"

namespace flyrock {

/// How far [m] a body of its attitude moves from `start` along the unit vector `direction` until it first
/// touches the terrain; nothing if it does not within `most`. Exact as the time of impact is.
template <int D>
std::optional<double> distance_to_ground(const Body<D>& body, const typename Geometry<D>::Terrain& terrain,
                                         const Vec<D>& start, const Vec<D>& direction, double most);

/// The place of the centre of mass at (x, y) in plan where a body of its attitude, lowered from above all
/// ground, first touches it; nothing where it meets no ground.
std::optional<Vec3> lowered_to_ground(const Body<3>& body, const Terrain3& terrain, double x, double y);

}  // namespace flyrock
