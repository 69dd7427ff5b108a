#include "geometry/ground_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/ground.h"

namespace flyrock {

namespace {

/// Collects polygons as triangles. Equal places become one vertex.
class SurfaceMesh {
 public:
  explicit SurfaceMesh(const std::vector<std::string>& parts) { mesh_.parts = parts; }

  /// A convex polygon, counter-clockwise as seen from outside.
  void add(const std::vector<Vec3>& polygon, int part) {
    std::vector<int> corners;
    for (const Vec3& place : polygon) {
      const int vertex = vertex_at(place);
      if (corners.empty() || (vertex != corners.back() && vertex != corners.front()))
        corners.push_back(vertex);
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
      mesh_.part.push_back(part);
    }
  }
  Mesh take() { return std::move(mesh_); }

 private:
  int vertex_at(const Vec3& place) {
    const auto [found, is_new] = vertices_.try_emplace({place.x(), place.y(), place.z()}, vertices_.size());
    if (is_new) mesh_.vertices.push_back(place);
    return found->second;
  }

  Mesh mesh_;
  std::map<std::array<double, 3>, int> vertices_;
};

/// Where the line from a to b has the coordinate `at` along `axis`: the same bits from either end, so that
/// two triangles are cut alike at their common edge.
Vec3 cut(Vec3 a, Vec3 b, int axis, double at) {
  if (std::lexicographical_compare(b.data(), b.data() + 3, a.data(), a.data() + 3)) std::swap(a, b);
  Vec3 place = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
  place[axis] = at;
  return place;
}

/// The part of a convex polygon on one side of an upright plane (Sutherland and Hodgman 1974).
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double at, bool above) {
  std::vector<Vec3> kept;
  const auto is_inside = [&](const Vec3& p) { return above ? p[axis] >= at : p[axis] <= at; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (is_inside(a)) kept.push_back(a);
    if (is_inside(a) != is_inside(b)) kept.push_back(cut(a, b, axis, at));
  }
  return kept;
}

/// A plane over the whole rectangle.
std::vector<Vec3> rectangle_on(const Facet& plane, const Box2& window) {
  std::vector<Vec3> corners = {{window.low.x(), window.low.y(), 0},
                               {window.high.x(), window.low.y(), 0},
                               {window.high.x(), window.high.y(), 0},
                               {window.low.x(), window.high.y(), 0}};
  for (Vec3& corner : corners) corner.z() -= plane.distance(corner) / plane.normal.z();
  return corners;
}

Mesh own_triangles(const Ground3& ground, const Box3& box) {
  std::vector<Facet> facets;
  ground.triangles(box, facets);
  const Box2 window{box.low.head<2>(), box.high.head<2>()};
  SurfaceMesh surface(ground.parts());
  for (const Facet& facet : facets) {
    std::vector<Vec3> polygon(facet.corner.begin(), facet.corner.end());
    if (facet.unbounded) polygon = rectangle_on(facet, window);
    for (const int axis : {0, 1}) {
      polygon = clipped(polygon, axis, window.low[axis], true);
      polygon = clipped(polygon, axis, window.high[axis], false);
    }
    surface.add(polygon, ground.part(facet.id));
  }
  return surface.take();
}

/// Heights at the multiples of `spacing` from the lower corner of the ground. Four neighbours make two
/// triangles, cut from south-west to north-east as those of a grid.
Mesh lattice_of(const Ground3& ground, const Box2& window, double spacing) {
  const Vec2 corner = ground.extent().low.head<2>();
  const auto number = [&](double at, int axis) { return std::llround((at - corner[axis]) / spacing); };
  std::array<long long, 2> first, last;
  for (const int axis : {0, 1}) {
    first[axis] = number(window.low[axis], axis);
    last[axis] = number(window.high[axis], axis);
  }
  SurfaceMesh surface(ground.parts());
  const auto place = [&](long long column, long long row) -> std::optional<Vec3> {
    const Vec2 at = corner + spacing * Vec2(static_cast<double>(column), static_cast<double>(row));
    const auto z = ground.height(at.x(), at.y());
    return z ? std::optional(Vec3(at.x(), at.y(), *z)) : std::nullopt;
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 middle = (a + b + c) / 3;
    const auto z = ground.height(middle.x(), middle.y());
    constexpr double on_it = 1e-3;  // m: around a place on the ground few facets are asked
    const auto nearest =
        ground.nearest({middle.x(), middle.y(), z.value_or(middle.z())}, z ? on_it : spacing);
    surface.add({a, b, c}, nearest ? ground.part(nearest->facet) : 0);
  };
  std::vector<std::optional<Vec3>> below, row;
  for (long long r = first[1]; r <= last[1]; ++r) {
    row.clear();
    for (long long c = first[0]; c <= last[0]; ++c) row.push_back(place(c, r));
    for (std::size_t i = 1; i < below.size(); ++i) {
      const auto &sw = below[i - 1], &se = below[i], &nw = row[i - 1], &ne = row[i];
      if (!sw || !se || !nw || !ne) continue;
      add(*sw, *se, *ne);
      add(*sw, *ne, *nw);
    }
    std::swap(below, row);
  }
  return surface.take();
}

/// The least multiple of the ground's cell whose lattice has at most about `most` triangles.
double lattice_spacing(const Ground3& ground, const Box2& window, std::size_t most) {
  const Vec2 size = (window.high - window.low).cwiseMax(0);
  const double wanted = std::sqrt(2 * size.x() * size.y() / static_cast<double>(most));
  return ground.cell() * std::max(1.0, std::ceil(wanted / ground.cell()));
}

}  // namespace

GroundSurface surface_within(const Ground3& ground, const Box2& window, std::size_t most) {
  const Box3& extent = ground.extent();
  Box3 box;
  box.low << window.low.cwiseMax(extent.low.head<2>()), extent.low.z();
  box.high << window.high.cwiseMin(extent.high.head<2>()), extent.high.z();
  if ((box.low.head<2>().array() > box.high.head<2>().array()).any()) return {};
  if (ground.count(box, static_cast<int>(most) + 1) <= static_cast<int>(most))
    return {own_triangles(ground, box), 0};
  const Box2 within{box.low.head<2>(), box.high.head<2>()};
  const double spacing = lattice_spacing(ground, within, most);
  return {lattice_of(ground, within, spacing), spacing};
}

std::vector<std::vector<Vec2>> heights_along(const Ground3& ground, const Vec2& from, const Vec2& to,
                                             int points) {
  std::vector<std::vector<Vec2>> lines(1);
  const double length = (to - from).norm();
  for (int i = 0; i < points; ++i) {
    const double share = i / (points - 1.0);
    const Vec2 at = from + share * (to - from);
    if (const auto z = ground.height(at.x(), at.y()))
      lines.back().emplace_back(share * length, *z);
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace flyrock
