#pragma once
// The ground below a flight.

#include <algorithm>
#include <utility>

#include "collision/geometry.h"

namespace flyrock {

/// Where the terrain begins and ends along x [m]; infinite if it has no end.
std::pair<double, double> extent(const Terrain2& terrain);
std::pair<double, double> extent(const Terrain3& terrain);

/// The height of the ground at or below a position within its extent [m], along the vertical axis (y in 2D, z
/// in 3D).
double ground_height(const Terrain2& terrain, const Vec2& at);
double ground_height(const Terrain3& terrain, const Vec3& at);

/// The mean velocity along x over [0, dt] [m/s], used to cut paths into pieces along x. It is exact without
/// air. In air the position error is |a_x| dt^2 / 8, less than a millimetre in a leg.
template <int D>
double rate_along_x(const Path<D>& path, double dt) {
  return path.v.x() + 0.5 * dt * path.a.x();
}

/// Calls visit(from, to, highest) for each part of [0, dt] in which the height of the path above the ground
/// is one quadratic function of time. highest(t0, t1) returns the greatest height [m] between t0 and t1 of
/// this part. In 2D each segment gives one part.
template <class Visit>
void visit_heights(const Terrain2& terrain, const Path<2>& path, double dt, Visit visit) {
  const Vec2 end = path.position(dt);
  const double rate = rate_along_x(path, dt);
  const auto run = terrain.segments_between(std::min(path.x.x(), end.x()), std::max(path.x.x(), end.x()));
  for (int i = run.first; i <= run.last; ++i) {
    const Vec2 &a = terrain.start(i), &b = terrain.end(i);
    if (b.x() <= a.x()) continue;  // vertical; its top belongs to a neighbour
    double from = 0, to = dt;
    if (rate != 0) {
      const double t1 = (a.x() - path.x.x()) / rate, t2 = (b.x() - path.x.x()) / rate;
      from = std::max(from, std::min(t1, t2));
      to = std::min(to, std::max(t1, t2));
      if (from > to) continue;
    }
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    const auto above = [&](double t) {
      const Vec2 p = path.position(t);
      return p.y() - (a.y() + slope * (p.x() - a.x()));
    };
    const double bend = path.a.y() - slope * path.a.x();
    const double top = bend < 0 ? (path.v.y() - slope * path.v.x()) / -bend : from;
    visit(from, to, [&](double t0, double t1) {
      return std::max({above(t0), above(std::clamp(top, t0, t1)), above(t1)});
    });
  }
}

/// Over a plane of normal n the height is (x - p).n / n_z.
template <class Visit>
void visit_heights(const Terrain3& terrain, const Path<3>& path, double dt, Visit visit) {
  const Plane& plane = terrain.plane();
  const auto above = [&](double t) { return plane.distance(path.position(t)) / plane.normal.z(); };
  const double fall = -plane.normal.dot(path.a);
  const double top = fall > 0 ? plane.normal.dot(path.v) / fall : 0;
  visit(0.0, dt, [&](double t0, double t1) {
    return std::max({above(t0), above(std::clamp(top, t0, t1)), above(t1)});
  });
}

}  // namespace flyrock
