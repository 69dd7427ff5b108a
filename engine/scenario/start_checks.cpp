#include "scenario/start_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flight/ground.h"

namespace flyrock {

namespace {

/// A rock that starts deeper than this share of its size inside the ground or another rock is refused.
constexpr double most_overlap = 1e-6;

/// How deep the middle of a contactor lies below the surface: what lies deep in the ground has no contact with it.
double buried(const Body<2>& body, const Terrain2& terrain) {
  double depth = 0;
  for (const Contactor2& contactor : body.contactors) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& point : contactor.points) middle += point / static_cast<double>(contactor.points.size());
    const Vec2 place = body.pose() * middle;
    depth = std::max(depth, terrain.height(place.x()) - place.y());
  }
  return depth;
}

/// The ground below a plane has contact at any depth.
double buried(const Body<3>&, const Terrain3&) { return 0; }

}  // namespace

template <int D>
void refuse_extremes(const Body<D>& body) {
  constexpr double most = 1e30;
  double inertia;  // the least moment
  if constexpr (D == 2)
    inertia = body.inertia;
  else
    inertia = body.inertia.minCoeff();
  if (body.mass > 1 / most && body.mass < most && std::isnormal(inertia)) return;
  throw PluginError(fmt::format("`{}` has a mass of {:.3g} kg and a moment of inertia of {:.3g} kg m2, expected a mass from "
                                "{:.0e} to {:.0e} kg",
                                body.group, body.mass, inertia, 1 / most, most));
}

template <int D>
void refuse_speed(const Body<D>& body) {
  constexpr double most_speed = 1e5, most_spin = 1e6;
  const double speed = body.v.norm(), spin = body.spin_speed();
  if (speed <= most_speed && spin <= most_spin) return;
  throw PluginError(fmt::format("`{}` starts with {:.3g} m/s and {:.3g} rad/s, expected at most {:.0e} m/s and {:.0e} rad/s",
                                body.group, speed, spin, most_speed, most_spin));
}

template <int D>
void check_start(World<D>& world) {
  double size = 0;
  const auto [low, high] = extent(world.terrain());
  for (const Body<D>& body : world.bodies) {
    if (!body.moves()) continue;
    size = std::max(size, body.size);
    if (body.x.x() < low || body.x.x() > high)
      throw PluginError(fmt::format("`{}` starts at x = {:.6g} m, beyond the terrain, which runs from {:.6g} to {:.6g} m",
                                    body.group, body.x.x(), low, high));
    if (const double depth = buried(body, world.terrain()); depth > most_overlap * body.size)
      throw PluginError(fmt::format("`{}` starts {:.3g} m inside the terrain", body.group, depth));
  }
  const auto overlap = world.deepest_overlap();
  if (overlap.depth <= most_overlap * size) return;
  const auto name = [&](int body) { return "`" + world.bodies[body].group + "`"; };
  throw PluginError(fmt::format("{} starts {:.3g} m inside {}", name(overlap.body), overlap.depth,
                                overlap.other < 0 ? "the terrain" : name(overlap.other)));
}

void check_start_of_point(const Body<3>& body, const Plane& plane) {
  if (const double depth = -plane.distance(body.x); depth > most_overlap * body.size)
    throw PluginError(fmt::format("`{}` starts at ({:.6g}, {:.6g}, {:.6g}) m, {:.3g} m inside the terrain", body.group, body.x.x(),
                                  body.x.y(), body.x.z(), depth));
}

void check_start_of_point(const Body<2>& body, const Profile& profile) {
  const bool beyond = body.x.x() < profile.x_min() || body.x.x() > profile.x_max();
  const double depth = beyond ? 0 : profile.height(body.x.x()) - body.x.y();
  if (beyond || depth > most_overlap * body.size)
    throw PluginError(fmt::format("`{}` starts at ({:.6g}, {:.6g}) m, {}", body.group, body.x.x(), body.x.y(),
                                  beyond ? "beyond the terrain" : fmt::format("{:.3g} m inside the terrain", depth)));
}

template <int D>
bool last_is_free(World<D>& world) {
  const Body<D>& last = world.bodies.back();
  return std::max(world.deepest_overlap().depth, buried(last, world.terrain())) <= most_overlap * last.size;
}

template void refuse_extremes(const Body<2>&);
template void refuse_extremes(const Body<3>&);
template void refuse_speed(const Body<2>&);
template void refuse_speed(const Body<3>&);
template void check_start(World<2>&);
template void check_start(World<3>&);
template bool last_is_free(World<2>&);
template bool last_is_free(World<3>&);

}  // namespace flyrock
