#pragma once
// Checks of bodies and their places before they start. Texts name the group of the body.

#include <optional>
#include <string>

#include "world/world.h"

namespace flyrock {

/// Nothing starts farther from the origin [m]: at this distance a double still resolves 1e-11 m.
inline constexpr double farthest_place = 1e5;

/// Refuses a mass or inertia for which the arithmetic of contacts overflows or loses the body. Throws
/// PluginError.
template <int D>
void refuse_extremes(const Body<D>& body);

/// Refuses a free body with a shape that has no mass: a half space or a surface. Throws StartError.
template <int D>
void refuse_massless(const Body<D>& body);

/// Refuses a surface that turns; its time of impact is that of a ground, which does not. Throws StartError.
template <int D>
void refuse_turning(const Body<D>& body);

/// Refuses a contactor that is much thinner than long. Contacts are found to a tolerance relative to its
/// length; a contactor as thin as this tolerance passes through surfaces. Throws PluginError.
template <int D>
void refuse_slender(const Body<D>& body);

/// Refuses a speed above 100 km/s or a spin above 10^6 rad/s, because the arithmetic of flights could
/// overflow. Throws PluginError.
template <int D>
void refuse_speed(const Body<D>& body);

/// A body that starts too far from the origin, beyond the ends of the terrain, inside the terrain or inside
/// another body.
struct StartFault {
  int body = 0;      ///< of two bodies, the one added later
  std::string text;  ///< with the radius that would fit if the ground is too near
};

/// A body that starts deeper in the ground or in another one than this share of its size is refused: where
/// the scenario has placed it, and where another run has left it, whose dense steps let contacts overlap.
inline constexpr double most_placed_overlap = 1e-6, most_left_overlap = 1e-3;

/// The first fault of the moving bodies of a world; nothing if there is none. Texts show places in the
/// coordinates of the scenario, in which the engine counts from `origin`.
template <int D>
std::optional<StartFault> start_fault(World<D>& world, const Vec3& origin = Vec3::Zero(),
                                      double most_overlap = most_placed_overlap);

/// The same of the body that was added last to others without a fault.
template <int D>
std::optional<StartFault> start_fault_of_last(World<D>& world, const Vec3& origin = Vec3::Zero());

/// The same for a point that flies over the ground of a terrain; empty if it may start.
std::string start_fault_of_point(const Body<3>& body, const Ground3& ground,
                                 const Vec3& origin = Vec3::Zero());
std::string start_fault_of_point(const Body<2>& body, const Profile& profile,
                                 const Vec3& origin = Vec3::Zero());

/// Whether the body added last starts without touching the others and the terrain.
template <int D>
bool last_is_free(World<D>& world);

}  // namespace flyrock
