#pragma once
// What a body must be, and where it must be, to start. All throw PluginError, which names the body's group.

#include "world/world.h"

namespace flyrock {

/// A mass and inertia with which the arithmetic of contacts neither overflows nor loses a body.
template <int D>
void refuse_extremes(const Body<D>& body);

/// A speed and spin with which the arithmetic of flights does not overflow: at most 100 km/s and 10^6 rad/s.
template <int D>
void refuse_speed(const Body<D>& body);

/// All moving bodies within the terrain's ends, and none inside the terrain or another.
template <int D>
void check_start(World<D>& world);

/// The same of a point that flies over the ground of a terrain.
void check_start_of_point(const Body<3>& body, const Plane& plane);
void check_start_of_point(const Body<2>& body, const Profile& profile);

/// Whether the body that was added last starts free of the others and the terrain.
template <int D>
bool last_is_free(World<D>& world);

}  // namespace flyrock
