#pragma once
// What a body must be, and where it must be, to start. Texts name the body's group.

#include <optional>
#include <string>

#include "world/world.h"

namespace flyrock {

/// Nothing starts farther from the origin [m]: there a double still keeps 1e-11 m.
inline constexpr double farthest_place = 1e5;

/// A mass and inertia with which the arithmetic of contacts neither overflows nor loses a body. Throws
/// PluginError.
template <int D>
void refuse_extremes(const Body<D>& body);

/// A contactor that is much thinner than long: contacts are found to a share of its length, and what is as
/// thin as that falls through. Throws PluginError.
template <int D>
void refuse_slender(const Body<D>& body);

/// A speed and spin with which the arithmetic of flights does not overflow: at most 100 km/s and 10^6 rad/s.
/// Throws PluginError.
template <int D>
void refuse_speed(const Body<D>& body);

/// A body that starts far from the origin, beyond the terrain's ends, inside the terrain or inside another
/// body.
struct StartFault {
  int body = 0;      ///< of two bodies the one that was added later
  std::string text;  ///< with the radius that would fit where the ground is too near
};

/// The first fault of the moving bodies of a world, or nothing.
template <int D>
std::optional<StartFault> start_fault(World<D>& world);

/// The same of a point that flies over the ground of a terrain: an empty text where it may start.
std::string start_fault_of_point(const Body<3>& body, const Plane& plane);
std::string start_fault_of_point(const Body<2>& body, const Profile& profile);

/// Whether the body that was added last starts free of the others and the terrain.
template <int D>
bool last_is_free(World<D>& world);

}  // namespace flyrock
