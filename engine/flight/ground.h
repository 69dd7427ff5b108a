#pragma once
// The ground below a flight.

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "collision/geometry.h"
#include "geometry/ground.h"

namespace flyrock {

/// Where the terrain begins and ends along each horizontal axis [m]; infinite if it has no end.
template <int D>
struct Domain {
  std::array<double, D - 1> low, high;
  bool contains(const Vec<D>& place) const {
    for (int k = 0; k < D - 1; ++k)
      if (place[k] < low[k] || place[k] > high[k]) return false;
    return true;
  }
};
Domain<2> domain_of(const Terrain2& terrain);
Domain<3> domain_of(const Terrain3& terrain);

inline const Profile& ground_of(const Terrain2& terrain) { return terrain.profile(); }
inline const Ground3& ground_of(const Terrain3& terrain) { return terrain.ground(); }

/// Which side of the terrain a place is beyond: the text of a fault. No place is named, because the engine
/// counts from its own origin.
template <int D>
std::string left_text(const Domain<D>& domain, const Vec<D>& place) {
  constexpr const char* axes[] = {"x", "y"};
  for (int k = 0; k < D - 1; ++k)
    if (place[k] <= domain.low[k] || place[k] >= domain.high[k])
      return std::string("it passed the end of the terrain towards ") +
             (place[k] <= domain.low[k] ? "-" : "+") + axes[k];
  return "it has no ground below it";
}

/// The height of the ground at or below a position [m], along the vertical axis (y in 2D, z in 3D). Nothing
/// where a terrain in 3D has no ground. Within an overhang, the ground below the position.
std::optional<double> ground_height(const Terrain2& terrain, const Vec2& at);
std::optional<double> ground_height(const Terrain3& terrain, const Vec3& at);

/// Whether there is ground below or above a position within the domain. Only a terrain in 3D may have none.
inline bool is_over_ground(const Terrain2&, const Vec2&) { return true; }
inline bool is_over_ground(const Terrain3& terrain, const Vec3& at) {
  return terrain.ground().whole() || ground_height(terrain, at);
}

/// How deep a position lies below the ground [m]: a vertical line up from it meets the surface from behind.
/// Not positive if it is free. `near`: a segment close to it in 2D (-1: not known).
double depth_below_ground(const Terrain2& terrain, const Vec2& at, int near = -1);
double depth_below_ground(const Terrain3& terrain, const Vec3& at, int near = -1);

/// Whether the surface of the ground is at most `reach` [m] from a position.
bool is_near_surface(const Terrain2& terrain, const Vec2& at, double reach);
bool is_near_surface(const Terrain3& terrain, const Vec3& at, double reach);

/// The time at which a path comes to a place without ground below, within the domain [s]; infinity if it does
/// not. Only a terrain in 3D has such places.
double time_over_ground(const Terrain2& terrain, const Path<2>& path, double dt);
double time_over_ground(const Terrain3& terrain, const Path<3>& path, double dt);

/// The mean velocity along x over [0, dt] [m/s], used to cut paths into pieces along x. It is exact without
/// air. In air the position error is |a_x| dt^2 / 8, less than a millimetre in a leg.
template <int D>
double rate_along_x(const Path<D>& path, double dt) {
  return path.v.x() + 0.5 * dt * path.a.x();
}

/// The height of a path above a straight piece of ground [m] as a function of time.
struct HeightOver {
  double start = 0, rate = 0, bend = 0;  ///< m at time 0, m/s, m/s2
  double at(double t) const { return start + t * (rate + 0.5 * t * bend); }
  double greatest(double from, double to) const {
    if (bend < 0) return at(std::max(from, std::min(-rate / bend, to)));
    return std::max(at(from), at(to));
  }
};

/// Calls visit(from, to, highest) for each part of [0, dt] in which the height of the path above the ground
/// is one quadratic function of time. highest(t0, t1) returns the greatest height [m] between t0 and t1 of
/// this part. In 2D each segment gives one part. `near` is a segment close to the path (-1: not known), and
/// then the one at its end.
template <class Visit>
void visit_heights(const Terrain2& terrain, const Path<2>& path, double dt, Visit visit, int& near) {
  const double rate = rate_along_x(path, dt), per_rate = rate != 0 ? 1 / rate : 0;
  const double from_x = path.x.x(), to_x = from_x + dt * rate;
  const auto run = terrain.segments_between(std::min(from_x, to_x), std::max(from_x, to_x), near);
  near = to_x < from_x ? run.first : run.last;
  for (int i = run.first; i <= run.last; ++i) {
    const Vec2 &a = terrain.start(i), &b = terrain.end(i);
    if (b.x() <= a.x()) continue;  // vertical; its top belongs to a neighbour
    double from = 0, to = dt;
    if (rate != 0) {
      const double t1 = (a.x() - path.x.x()) * per_rate, t2 = (b.x() - path.x.x()) * per_rate;
      from = std::max(from, std::min(t1, t2));
      to = std::min(to, std::max(t1, t2));
      if (from > to) continue;
    }
    const double slope = terrain.slope(i);
    const HeightOver height{path.x.y() - a.y() - slope * (path.x.x() - a.x()),
                            path.v.y() - slope * path.v.x(), path.a.y() - slope * path.a.x()};
    visit(from, to, [&](double t0, double t1) { return height.greatest(t0, t1); });
  }
}

/// When a path is over a facet, in plan, within [0, dt]; empty if it is not. Paths are straight in plan, as
/// for rate_along_x.
TimeWindow over_facet(const Facet& facet, const Path<3>& path, double dt);

/// The facets that a path may pass over within [0, dt]. Valid until the next call on this thread.
const std::vector<Facet>& facets_below(const Terrain3& terrain, const Path<3>& path, double dt);

template <class Visit>
void visit_heights(const Terrain2& terrain, const Path<2>& path, double dt, Visit visit) {
  int near = -1;
  visit_heights(terrain, path, dt, visit, near);
}

/// In 3D each facet below the path gives one part. Over a facet of normal n the height is (x - p).n / n_z.
template <class Visit>
void visit_heights(const Terrain3& terrain, const Path<3>& path, double dt, Visit visit) {
  for (const Facet& f : facets_below(terrain, path, dt)) {
    if (!(f.normal.z() > 0)) continue;  // upright or facing down
    const TimeWindow over = over_facet(f, path, dt);
    if (over.empty()) continue;
    const double steep = 1 / f.normal.z();
    const HeightOver height{f.distance(path.x) * steep, f.normal.dot(path.v) * steep,
                            f.normal.dot(path.a) * steep};
    if (terrain.ground().overhangs()) {  // another facet may be nearer below the path
      const Vec3 middle = path.position(0.5 * (over.a + over.b));
      const auto ground = terrain.ground().crossing(middle, false);
      if (!ground || middle.z() - ground->z < height.at(0.5 * (over.a + over.b)) * (1 - 1e-9)) continue;
    }
    visit(over.a, over.b, [&](double t0, double t1) { return height.greatest(t0, t1); });
  }
}

template <class Visit>
void visit_heights(const Terrain3& terrain, const Path<3>& path, double dt, Visit visit, int&) {
  visit_heights(terrain, path, dt, visit);
}

}  // namespace flyrock
