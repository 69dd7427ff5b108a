#include "trial/start_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "collision/hollow/hollow_wall.h"
#include "collision/outline/outline.h"
#include "flight/ground.h"
#include "geometry/place_text.h"
#include "geometry/volume_properties.h"

namespace flyrock {

namespace {

/// How deep the middle of a contactor lies below the surface. A contactor deep in the ground has no contact
/// with it, so contacts alone do not find it. The ground below a plane has contacts at any depth.
template <int D>
double buried(const Body<D>& body, const typename Geometry<D>::Terrain& terrain) {
  if (std::isinf(domain_of(terrain).low[0])) return 0;
  double depth = 0;
  for (const auto& contactor : body.contactors)
    if (!is_hollow(contactor.form))  // the ground does not touch it
      depth = std::max(depth, depth_below_ground(terrain, body.pose() * middle_of(contactor)));
  return depth;
}

/// The surface in which the middle of a contactor lies, and how deep. Contacts do not find it, as above.
template <int D>
struct InSurface {
  double depth = 0;
  const Body<D>* surface = nullptr;
};
template <int D>
InSurface<D> in_surface(const Body<D>& body, const std::vector<Body<D>>& bodies) {
  InSurface<D> deepest;
  for (const Body<D>& other : bodies) {
    if (!other.is_outline()) continue;
    for (const auto& contactor : body.contactors) {
      if (is_hollow(contactor.form)) continue;
      const double depth =
          depth_in_outline({other.contactors.front(), other.pose()}, body.pose() * middle_of(contactor));
      if (depth > deepest.depth) deepest = {depth, &other};
    }
  }
  return deepest;
}

/// The distance from a place above the ground to the ground [m]; 0 below it. In 3D at most `most`.
double room_at(const Vec2& place, const Terrain2& terrain, double) {
  if (place.y() <= terrain.height(place.x())) return 0;
  double room = 1e300;
  const Profile& profile = terrain.profile();
  for (int i = 0; i < profile.segments(); ++i) {
    const Vec2 along = profile.points[i + 1] - profile.points[i], to = place - profile.points[i];
    const double share = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
    room = std::min(room, (to - share * along).norm());
  }
  return room;
}

double room_at(const Vec3& place, const Terrain3& terrain, double most) {
  if (depth_below_ground(terrain, place) > 0) return 0;
  const auto nearest = terrain.ground().nearest(place, most);
  return nearest ? nearest->distance : most;
}

/// Whether a length divided by a thickness says nothing of a contactor.
bool is_compact(Form form) { return form == Form::ball || form == Form::outline || is_hollow(form); }

/// The length of a contactor divided by its thickness, as if it were a rectangle or a box; exact for these.
double slenderness(const Contactor2& contactor) {
  if (is_compact(contactor.form)) return 1;
  double length = 0;
  for (const Vec2& point : contactor.points)
    length = std::max(length, (point - contactor.points.front()).norm());
  length += 2 * contactor.radius;
  return length * length / area_properties({contactor}).area;
}

double slenderness(const Contactor3& contactor) {
  if (is_compact(contactor.form)) return 1;
  const Vec3 moments = principal_frame(volume_properties({contactor}).inertia).moments;
  const Vec3 squares = Vec3::Constant(0.5 * moments.sum()) -
                       moments;  // integrals of x^2, y^2, z^2: proportional to a side squared
  return std::sqrt(squares.maxCoeff() / std::max(0.0, squares.minCoeff()));
}

/// Where a body starts, in the coordinates of the scenario: "(5, 12.1) m".
template <int D>
std::string start_text(const Body<D>& body, const Vec3& origin) {
  return place_text(Vec<D>(body.x + origin.head<D>())) + " m";
}

/// "`rock` starts at (5, 12.1) m, "
template <int D>
std::string starts_text(const Body<D>& body, const Vec3& origin) {
  return fmt::format("`{}` starts at {}, ", body.group, start_text(body, origin));
}

/// What is wrong with a point this deep below the ground, or an empty text.
template <int D>
std::string buried_text(const Body<D>& body, double depth, const Vec3& origin) {
  if (!(depth > most_placed_overlap * body.size)) return {};
  return starts_text(body, origin) + fmt::format("{:.3g} m inside the terrain", depth);
}

template <int D>
std::string far_text(const Body<D>& body, const Vec3& origin) {
  return fmt::format("`{}` starts at {}, more than 100 km from the origin", body.group,
                     start_text(body, origin));
}

/// What is wrong with a place beyond the terrain, or an empty text.
template <int D>
std::string beyond_text(const Body<D>& body, const Domain<D>& domain, const Vec3& origin) {
  constexpr const char* axes[] = {"x", "y"};
  for (int k = 0; k < D - 1; ++k)
    if (body.x[k] < domain.low[k] || body.x[k] > domain.high[k])
      return fmt::format("`{}` starts at {} = {} m, beyond the terrain, which runs from {} to {} m",
                         body.group, axes[k], coordinate_text(body.x[k] + origin[k]),
                         coordinate_text(domain.low[k] + origin[k]),
                         coordinate_text(domain.high[k] + origin[k]));
  return {};
}

template <int D>
std::string inside_terrain(const Body<D>& body, double depth, const typename Geometry<D>::Terrain& terrain,
                           const Vec3& origin) {
  const double room = room_at(body.x, terrain, body.size);
  const std::string start = fmt::format("`{}` starts at {}, {:.3g} m inside the terrain", body.group,
                                        start_text(body, origin), depth);
  if (room == 0) return start + ": its centre of mass is below the ground, where no radius fits";
  return start +
         fmt::format(": it reaches {:.3g} m from its centre of mass, a radius of at most {:.3g} m fits there",
                     body.size, room);
}

template <int D>
std::string inside_text(const Body<D>& body, double depth, const Body<D>& other) {
  return fmt::format("`{}` starts {:.3g} m inside `{}`", body.group, depth, other.group);
}

}  // namespace

template <int D>
void refuse_extremes(const Body<D>& body) {
  constexpr double most = 1e30;
  double inertia;  // the smallest moment
  if constexpr (D == 2)
    inertia = body.inertia;
  else
    inertia = body.inertia.minCoeff();
  if (body.mass > 1 / most && body.mass < most && std::isnormal(inertia)) return;
  if (body.mass == 0 && body.volume == 0)
    throw StartError(fmt::format("`{}` has no volume: expected `mass` in place of `density`", body.group));
  throw StartError(fmt::format(
      "`{}` has a mass of {:.3g} kg and a moment of inertia of {:.3g} kg m2, expected a mass from "
      "{:.0e} to {:.0e} kg",
      body.group, body.mass, inertia, 1 / most, most));
}

template <int D>
void refuse_massless(const Body<D>& body) {
  if (body.is_outline())
    throw StartError(fmt::format(
        "`{}` is a surface, which other bodies do not move: expected `fixed: true` or `driven`", body.group));
  if constexpr (D == 3)
    for (const Contactor3& contactor : body.contactors)
      if (contactor.form == Form::half_space)
        throw StartError(
            fmt::format("`{}` is a plane without end, which has no mass: expected `fixed: true` or `driven`",
                        body.group));
}

template <int D>
void refuse_turning(const Body<D>& body) {
  if (body.is_outline() && body.spin_speed() > 0)
    throw StartError(
        fmt::format("`{}` is a surface, which moves without turning: expected a spin of 0", body.group));
}

template <int D>
void refuse_slender(const Body<D>& body) {
  constexpr double most = 1e4;
  for (const auto& contactor : body.contactors)
    if (const double times = slenderness(contactor); !(times <= most * (1 + 1e-6)))
      throw StartError(fmt::format("`{}` is {:.3g} times as long as thick, expected at most {:g} times",
                                   body.group, times, most));
}

template <int D>
void refuse_speed(const Body<D>& body) {
  constexpr double most_speed = 1e5, most_spin = 1e6;
  const double speed = body.v.norm(), spin = body.spin_speed();
  if (speed <= most_speed && spin <= most_spin) return;
  throw StartError(fmt::format(
      "`{}` starts with {:.3g} m/s and {:.3g} rad/s, expected at most {:.0e} m/s and {:.0e} rad/s",
      body.group, speed, spin, most_speed, most_spin));
}

namespace {

/// What is wrong with the place of one body, apart from the contacts that it has; or an empty text.
template <int D>
std::string place_fault(const World<D>& world, const Body<D>& body, const Vec3& origin, double most_overlap) {
  if (!(body.x.cwiseAbs().maxCoeff() <= farthest_place)) return far_text(body, origin);
  if (!body.moves()) return {};
  if (const std::string beyond = beyond_text(body, domain_of(world.terrain()), origin); !beyond.empty())
    return beyond;
  if (!ground_height(world.terrain(), body.x))
    return fmt::format("`{}` starts at {}, where there is no ground", body.group, start_text(body, origin));
  if (const double depth = buried(body, world.terrain()); depth > most_overlap * body.size)
    return inside_terrain(body, depth, world.terrain(), origin);
  if (const auto in = in_surface(body, world.bodies); in.depth > most_overlap * body.size)
    return inside_text(body, in.depth, *in.surface);
  return {};
}

template <int D>
std::optional<StartFault> overlap_fault(const World<D>& world, const typename World<D>::Overlap& overlap,
                                        const Vec3& origin, double most_overlap) {
  double size = 0;
  for (const Body<D>& body : world.bodies)
    if (body.moves()) size = std::max(size, body.size);
  if (overlap.depth <= most_overlap * size) return std::nullopt;
  const Body<D>& body = world.bodies[overlap.body];
  if (overlap.other < 0)
    return StartFault{overlap.body, inside_terrain(body, overlap.depth, world.terrain(), origin)};
  return StartFault{overlap.body, inside_text(body, overlap.depth, world.bodies[overlap.other])};
}

}  // namespace

template <int D>
std::optional<StartFault> start_fault(World<D>& world, const Vec3& origin, double most_overlap) {
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
    if (std::string fault = place_fault(world, world.bodies[i], origin, most_overlap); !fault.empty())
      return StartFault{i, std::move(fault)};
  return overlap_fault(world, world.deepest_overlap(), origin, most_overlap);
}

template <int D>
std::optional<StartFault> start_fault_of_last(World<D>& world, const Vec3& origin) {
  const int last = static_cast<int>(world.bodies.size()) - 1;
  if (std::string fault = place_fault(world, world.bodies.back(), origin, most_placed_overlap);
      !fault.empty())
    return StartFault{last, std::move(fault)};
  return overlap_fault(world, world.overlap_of_last(), origin, most_placed_overlap);
}

std::string start_fault_of_point(const Body<3>& body, const Ground3& ground, const Vec3& origin) {
  if (!(body.x.cwiseAbs().maxCoeff() <= farthest_place)) return far_text(body, origin);
  if (!ground.height(body.x.x(), body.x.y())) return starts_text(body, origin) + "where there is no ground";
  return buried_text(body, ground.depth(body.x), origin);
}

std::string start_fault_of_point(const Body<2>& body, const Profile& profile, const Vec3& origin) {
  if (!(body.x.cwiseAbs().maxCoeff() <= farthest_place)) return far_text(body, origin);
  if (body.x.x() < profile.x_min() || body.x.x() > profile.x_max())
    return starts_text(body, origin) + fmt::format("beyond the terrain, which runs from {} to {} m",
                                                   coordinate_text(profile.x_min()),
                                                   coordinate_text(profile.x_max()));
  return buried_text(body, profile.height(body.x.x()) - body.x.y(), origin);
}

template <int D>
bool last_is_free(World<D>& world) {
  const Body<D>& last = world.bodies.back();
  const double depth = std::max(buried(last, world.terrain()), in_surface(last, world.bodies).depth);
  return std::max(world.overlap_of_last().depth, depth) <= most_placed_overlap * last.size;
}

template void refuse_extremes(const Body<2>&);
template void refuse_extremes(const Body<3>&);
template void refuse_massless(const Body<2>&);
template void refuse_massless(const Body<3>&);
template void refuse_turning(const Body<2>&);
template void refuse_turning(const Body<3>&);
template void refuse_slender(const Body<2>&);
template void refuse_slender(const Body<3>&);
template void refuse_speed(const Body<2>&);
template void refuse_speed(const Body<3>&);
template std::optional<StartFault> start_fault(World<2>&, const Vec3&, double);
template std::optional<StartFault> start_fault(World<3>&, const Vec3&, double);
template std::optional<StartFault> start_fault_of_last(World<2>&, const Vec3&);
template std::optional<StartFault> start_fault_of_last(World<3>&, const Vec3&);
template bool last_is_free(World<2>&);
template bool last_is_free(World<3>&);

}  // namespace flyrock
