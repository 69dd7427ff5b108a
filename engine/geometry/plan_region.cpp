#include "geometry/plan_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/doubled_area.h"
#include "geometry/plan_zone.h"

namespace flyrock {

namespace {

/// A place just inside of a counter-clockwise ring, at its longest edge: other rings may share its corners.
Vec2 place_inside(const PlanRing& ring) {
  std::size_t longest = 0;
  const auto edge = [&](std::size_t i) { return Vec2(ring[(i + 1) % ring.size()] - ring[i]); };
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (edge(i).squaredNorm() > edge(longest).squaredNorm()) longest = i;
  constexpr double inwards = 1e-6;
  const Vec2 along = edge(longest);
  return ring[longest] + 0.5 * along + inwards * Vec2(-along.y(), along.x());
}

/// Directed edges between numbered corners, with the region on their left. An edge and its reverse cancel,
/// so the inner edges of neighbours vanish.
class BorderEdges {
 public:
  void add(int from, int to) {
    if (from == to) return;
    const auto back = edges_.find({to, from});
    if (back == edges_.end())
      ++edges_[{from, to}];
    else if (--back->second == 0)
      edges_.erase(back);
  }

  /// As many edges leave a corner as arrive there, so each way through them closes. Where the way is at one
  /// of its own corners again, it has closed a ring: no ring touches itself.
  std::vector<std::vector<int>> rings() const {
    std::map<int, std::vector<int>> leaving;
    for (const auto& [edge, count] : edges_)
      for (int i = 0; i < count; ++i) leaving[edge.first].push_back(edge.second);
    std::vector<std::vector<int>> rings;
    for (auto& [start, next] : leaving)
      while (!next.empty()) follow(start, leaving, rings);
    return rings;
  }

 private:
  static void follow(int start, std::map<int, std::vector<int>>& leaving,
                     std::vector<std::vector<int>>& rings) {
    std::vector<int> way = {start};
    std::map<int, std::size_t> on_way = {{start, 0}};
    while (!leaving[way.back()].empty()) {
      std::vector<int>& from_here = leaving[way.back()];
      const int next = from_here.back();
      from_here.pop_back();
      const auto known = on_way.find(next);
      if (known == on_way.end()) {
        on_way[next] = way.size();
        way.push_back(next);
        continue;
      }
      const auto first = way.begin() + static_cast<std::ptrdiff_t>(known->second);
      rings.emplace_back(first, way.end());
      for (auto corner = first + 1; corner != way.end(); ++corner) on_way.erase(*corner);
      way.erase(first + 1, way.end());
    }
  }

  std::map<std::pair<int, int>, int> edges_;
};

/// Without corners on a straight line.
PlanRing without_straight_corners(const PlanRing& ring) {
  constexpr double straight = 1e-9;
  PlanRing corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vec2 after = ring[(i + 1) % ring.size()] - ring[i];
    if (std::abs(cross(before, after)) > straight * before.norm() * after.norm()) corners.push_back(ring[i]);
  }
  return corners;
}

template <class Place>
std::vector<PlanRing> placed(const BorderEdges& edges, Place place) {
  std::vector<PlanRing> rings;
  for (const std::vector<int>& numbers : edges.rings()) {
    PlanRing ring;
    for (const int corner : numbers) ring.push_back(place(corner));
    ring = without_straight_corners(ring);
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace

std::vector<PlanPolygon> polygons_of(std::vector<PlanRing> rings) {
  struct Nested {
    PlanRing ring;
    Eigen::AlignedBox2d box;
    Vec2 inside;
    std::vector<std::size_t> about;  ///< the rings that contain it
    std::size_t polygon = 0;         ///< of an outline
  };
  std::vector<Nested> all;
  for (PlanRing& ring : rings) {
    const double area = doubled_area(ring);
    if (area == 0) continue;
    if (area < 0) std::reverse(ring.begin(), ring.end());
    Eigen::AlignedBox2d box;
    for (const Vec2& corner : ring) box.extend(corner);
    const Vec2 inside = place_inside(ring);
    all.push_back({.ring = std::move(ring), .box = box, .inside = inside, .about = {}});
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j)
      if (i != j && all[j].box.contains(all[i].inside) && is_inside(all[j].ring, all[i].inside))
        all[i].about.push_back(j);
  std::vector<PlanPolygon> polygons;
  for (Nested& outline : all) {
    if (outline.about.size() % 2 != 0) continue;
    outline.polygon = polygons.size();
    polygons.push_back({outline.ring, {}});
  }
  for (const Nested& hole : all) {
    if (hole.about.size() % 2 == 0) continue;
    for (const std::size_t j : hole.about)  // the innermost ring about it is the outline of its polygon
      if (all[j].about.size() + 1 == hole.about.size())
        polygons[all[j].polygon].holes.emplace_back(hole.ring.rbegin(), hole.ring.rend());
  }
  return polygons;
}

std::vector<PlanRing> rings_around_cells(const HeightGrid& grid,
                                         const std::function<bool(double value)>& is_inside) {
  const int corners = grid.columns + 1;  // in a row
  BorderEdges edges;
  const auto covers = [&](int column, int row) {
    return column >= 0 && column < grid.columns && row >= 0 && row < grid.rows &&
           is_inside(grid.at(column, row));
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!covers(column, row)) continue;
      const int south_west = row * corners + column, north_west = south_west + corners;
      if (!covers(column, row - 1)) edges.add(south_west, south_west + 1);
      if (!covers(column + 1, row)) edges.add(south_west + 1, north_west + 1);
      if (!covers(column, row + 1)) edges.add(north_west + 1, north_west);
      if (!covers(column - 1, row)) edges.add(north_west, south_west);
    }
  return placed(edges, [&](int corner) {
    return Vec2(grid.corner + grid.cell * Vec2(corner % corners - 0.5, corner / corners - 0.5));
  });
}

std::vector<PlanRing> rings_around_part(const Mesh& mesh, int part) {
  std::map<std::array<double, 2>, int> numbers;  // corners at one place in plan are one
  std::vector<Vec2> places;
  const auto number_of = [&](int vertex) {
    const Vec2 place = mesh.vertices[static_cast<std::size_t>(vertex)].head<2>();
    const auto [found, is_new] = numbers.try_emplace({place.x(), place.y()}, static_cast<int>(places.size()));
    if (is_new) places.push_back(place);
    return found->second;
  };
  BorderEdges edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.part[t] != part) continue;
    const auto& corners = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) edges.add(number_of(corners[k]), number_of(corners[(k + 1) % 3]));
  }
  return placed(edges, [&](int corner) { return places[static_cast<std::size_t>(corner)]; });
}

}  // namespace flyrock
