#include "trial/touch_ground.h"

#include <algorithm>
#include <cmath>

#include "collision/pairs.h"
#include "geometry/ground.h"

namespace flyrock {

namespace {

Motion2 straight(const Body<2>& body, const Vec2& start, const Vec2& direction) {
  Motion2 motion;
  motion.x = start;
  motion.v = direction;
  motion.angle = body.attitude.angle;
  return motion;
}

Motion3 straight(const Body<3>& body, const Vec3& start, const Vec3& direction) {
  Motion3 motion;
  motion.x = start;
  motion.v = direction;
  motion.rotation = GivenRotation{.start = body.attitude.rotation};
  return motion;
}

}  // namespace

template <int D>
std::optional<double> distance_to_ground(const Body<D>& body, const typename Geometry<D>::Terrain& terrain,
                                         const Vec<D>& start, const Vec<D>& direction, double most) {
  const auto motion = straight(body, start, direction);  // 1 m/s: a time is a distance
  TouchSearch search;
  search.size = body.size;
  Workspace work;
  std::optional<double> first;
  for (std::size_t k = 0; k < body.contactors.size(); ++k)
    if (const auto touch = time_of_contact<D>(work, {body.contactors[k], motion, static_cast<int>(k)},
                                              terrain, first.value_or(most), search))
      first = std::min(*touch, first.value_or(most));
  return first;
}

std::optional<Vec3> lowered_to_ground(const Body<3>& body, const Terrain3& terrain, double x, double y) {
  const Ground3& ground = terrain.ground();
  const std::optional<double> below = ground.height(x, y);
  if (!below) return std::nullopt;
  double top = ground.extent().high.z(), bottom = ground.extent().low.z();
  if (!std::isfinite(top)) {  // a plane: what of it is within the size of the body
    const Vec3 normal = ground.facet(0).normal;
    const double rise = body.size * normal.head<2>().norm() / normal.z();
    top = *below + rise;
    bottom = *below - rise;
  }
  const Vec3 start(x, y, top + 2 * body.size);
  const auto fall =
      distance_to_ground<3>(body, terrain, start, -Vec3::UnitZ(), start.z() - bottom + 2 * body.size);
  return fall ? std::optional<Vec3>(start - *fall * Vec3::UnitZ()) : std::nullopt;
}

template std::optional<double> distance_to_ground<2>(const Body<2>&, const Terrain2&, const Vec2&,
                                                     const Vec2&, double);
template std::optional<double> distance_to_ground<3>(const Body<3>&, const Terrain3&, const Vec3&,
                                                     const Vec3&, double);

}  // namespace flyrock
