#include "flight/region_means.h"

namespace flyrock {

namespace {

/// The area of a disk, the volume of a sphere [m2, m3].
template <int D>
double size_of_ball(double radius) {
  return D == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
}

template <int D>
bool is_in(const World<D>& world, int body, const RegionBox& region) {
  if (body < 0 || !world.bodies[body].moves()) return false;
  const Vec<D> place = world.bodies[body].x + world.origin;
  return (place.array() >= region.low.head<D>().array()).all() &&
         (place.array() <= region.high.head<D>().array()).all();
}

}  // namespace

template <int D>
SeriesRegion region_means(const World<D>& world, const RegionBox& region, double step) {
  SeriesRegion means{.time = world.time, .region = region.name, .step = step};
  double filled = 0, volume = 0;  // in 2D of areas; m3
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i) {
    if (!is_in(world, i, region)) continue;
    ++means.bodies;
    filled += size_of_ball<D>(world.bodies[i].radius);
    volume += world.bodies[i].volume;
  }
  if (means.bodies == 0) return means;
  const double size = (region.high - region.low).head<D>().prod();
  means.porosity = 1 - filled / size;

  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();  // N m
  for (const WorldContact<D>& contact : world.contacts()) {
    const Vec<D> force = contact.impulse_on_candidate() / step;
    const auto add = [&](int body, const Vec<D>& on_body) {
      if (is_in(world, body, region))
        sum.topLeftCorner<D, D>() += on_body * (world.bodies[body].x - contact.at.point).transpose();
    };
    add(contact.candidate, force);
    add(contact.antagonist, -force);
  }
  const double thickness = volume / filled;  // 1 in 3D
  const Eigen::Matrix3d stress = (sum + sum.transpose()) / (2 * size * thickness);
  means.stress_xx = stress(0, 0);
  means.stress_yy = stress(1, 1);
  means.stress_zz = stress(2, 2);
  means.stress_xy = stress(0, 1);
  means.stress_xz = stress(0, 2);
  means.stress_yz = stress(1, 2);
  return means;
}

template SeriesRegion region_means(const World<2>&, const RegionBox&, double);
template SeriesRegion region_means(const World<3>&, const RegionBox&, double);

}  // namespace flyrock
