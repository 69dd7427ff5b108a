#include "flight/ground.h"

namespace flyrock {

namespace {

/// The mean velocity in plan over [0, dt] [m/s].
Vec2 rate_in_plan(const Path<3>& path, double dt) { return (path.v + 0.5 * dt * path.a).head<2>(); }

}  // namespace

Domain<2> domain_of(const Terrain2& terrain) {
  return {{terrain.profile().x_min()}, {terrain.profile().x_max()}};
}

Domain<3> domain_of(const Terrain3& terrain) {
  const Box3& box = terrain.ground().extent();
  return {{box.low.x(), box.low.y()}, {box.high.x(), box.high.y()}};
}

std::optional<double> ground_height(const Terrain2& terrain, const Vec2& at) {
  return terrain.profile().height(at.x());
}

std::optional<double> ground_height(const Terrain3& terrain, const Vec3& at) {
  if (!terrain.ground().overhangs()) return terrain.ground().height(at.x(), at.y());
  const auto below = terrain.ground().crossing(at, false);
  return below ? std::optional(below->z) : terrain.ground().height(at.x(), at.y());
}

double depth_below_ground(const Terrain2& terrain, const Vec2& at, int near) {
  return terrain.top(at.x(), near) - at.y();
}

double depth_below_ground(const Terrain3& terrain, const Vec3& at, int) { return terrain.ground().depth(at); }

bool is_near_surface(const Terrain2& terrain, const Vec2& at, double reach) {
  const auto run = terrain.segments_between(at.x() - reach, at.x() + reach);
  for (int i = run.first; i <= run.last; ++i) {
    const double along = std::clamp((at - terrain.start(i)).dot(terrain.tangent(i)), 0.0, terrain.length(i));
    if ((terrain.start(i) + along * terrain.tangent(i) - at).norm() <= reach) return true;
  }
  return false;
}

bool is_near_surface(const Terrain3& terrain, const Vec3& at, double reach) {
  return terrain.ground().nearest(at, reach).has_value();
}

double time_over_ground(const Terrain2&, const Path<2>&, double) { return infinite; }

/// The times over all facets leave a gap where the ground ends.
double time_over_ground(const Terrain3& terrain, const Path<3>& path, double dt) {
  if (terrain.ground().whole()) return infinite;
  thread_local std::vector<TimeWindow> over;  // keeps its memory between calls
  over.clear();
  for (const Facet& facet : facets_below(terrain, path, dt))
    if (const TimeWindow window = over_facet(facet, path, dt); !window.empty()) over.push_back(window);
  std::sort(over.begin(), over.end(), [](const TimeWindow& a, const TimeWindow& b) { return a.a < b.a; });
  const double rounding = 1e-9 * dt;
  double until = 0;
  for (const TimeWindow& window : over) {
    if (window.a > until + rounding) break;
    until = std::max(until, window.b);
  }
  return until < dt ? until : infinite;
}

TimeWindow over_facet(const Facet& f, const Path<3>& path, double dt) {
  TimeWindow window{0, dt};
  if (f.unbounded) return window;
  const Vec2 rate = rate_in_plan(path, dt);
  const double facing = f.normal.z() < 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i) {
    // In plan: (distance of the path inside this side) x (length of the side) = from + t change [m2]. Over
    // the facet all three are >= 0.
    const Vec2 along = f.along(i).head<2>();
    const double from = facing * cross(along, Vec2(path.x.head<2>() - f.corner[i].head<2>())),
                 change = facing * cross(along, rate);
    const double slack = 1e-12 * along.squaredNorm();
    if (change == 0) {
      if (from < -slack) return {};
      continue;
    }
    const double crosses = (-slack - from) / change;
    if (change > 0)
      window.a = std::max(window.a, crosses);
    else
      window.b = std::min(window.b, crosses);
  }
  return window;
}

const std::vector<Facet>& facets_below(const Terrain3& terrain, const Path<3>& path, double dt) {
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  facets.clear();
  const Vec2 start = path.x.head<2>();
  terrain.ground().triangles_under(start, start + dt * rate_in_plan(path, dt), facets);
  return facets;
}

}  // namespace flyrock
