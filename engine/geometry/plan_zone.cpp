#include "geometry/plan_zone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/place_text.h"
#include "geometry/plan_line.h"

namespace flyrock {

namespace {

/// A corner or line this close to a vertex or an edge counts as on it [m], because a cut there would leave a
/// triangle thinner than this.
constexpr double on_it = 1e-3;

/// Cuts a mesh along lines in plan. Each cut splits all triangles at an edge alike, so that no triangle ends
/// in the middle of the side of another.
class Cutter {
 public:
  explicit Cutter(Mesh& mesh) : mesh_(mesh) {}

  void cut(const std::vector<Vec2>& polygon) {
    // Corners first: a line then runs from vertex to vertex and leaves no triangle half cut.
    for (const Vec2& corner : polygon) insert(corner);
    for (std::size_t i = 0; i < polygon.size(); ++i) cut(polygon[i], polygon[(i + 1) % polygon.size()]);
  }

 private:
  Vec2 plan(int vertex) const { return mesh_.vertices[vertex].head<2>(); }

  int add_vertex(const Vec3& place) {
    mesh_.vertices.push_back(place);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  void add_triangle(int a, int b, int c, int part) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.part.push_back(part);
  }

  /// Makes a place in plan a vertex of every triangle above or below it.
  void insert(const Vec2& p) {
    const std::size_t known = mesh_.triangles.size();
    for (std::size_t t = 0; t < known; ++t) {
      const std::array<int, 3> corner = mesh_.triangles[t];
      const Vec2 a = plan(corner[0]), b = plan(corner[1]), c = plan(corner[2]);
      const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
      const double whole = cross(Vec2(b - a), Vec2(c - a));
      const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      if (std::abs(whole) < on_it * longest) continue;  // nearly upright: the cut of its edges is enough
      double inside[3];                                 // distance from side k, positive inside [m]
      for (int k = 0; k < 3; ++k) {
        const Vec2 from = plan(corner[k]), along = plan(corner[(k + 1) % 3]) - from;
        inside[k] = cross(along, Vec2(p - from)) / along.norm() * (whole < 0 ? -1 : 1);
      }
      if (std::min({inside[0], inside[1], inside[2]}) < on_it) continue;  // at an edge, which is cut below
      const Vec3 &first = mesh_.vertices[corner[0]], &second = mesh_.vertices[corner[1]],
                 &third = mesh_.vertices[corner[2]];
      const double u = cross(Vec2(p - a), Vec2(c - a)) / whole, v = cross(Vec2(b - a), Vec2(p - a)) / whole;
      const double z = first.z() + u * (second.z() - first.z()) + v * (third.z() - first.z());
      const int middle = add_vertex({p.x(), p.y(), z}), part = mesh_.part[t];
      mesh_.triangles[t] = {corner[0], corner[1], middle};
      add_triangle(corner[1], corner[2], middle, part);
      add_triangle(corner[2], corner[0], middle, part);
    }
  }

  void cut(const Vec2& from, const Vec2& to) {
    const double length = (to - from).norm();
    const Vec2 along = (to - from) / length;
    const auto beside = [&](int vertex) { return cross(along, Vec2(plan(vertex) - from)); };
    std::map<std::pair<int, int>, int> cuts;  // an edge -> its new vertex, or -1
    const auto cut_of = [&](int a, int b) {
      const std::pair<int, int> edge = std::minmax(a, b);
      const auto found = cuts.find(edge);
      if (found != cuts.end()) return found->second;
      const double left = beside(edge.first), right = beside(edge.second);
      int vertex = -1;
      if (left * right < 0 && std::min(std::abs(left), std::abs(right)) > on_it) {
        const Vec3 &low = mesh_.vertices[edge.first], &high = mesh_.vertices[edge.second];
        const Vec3 place = low + left / (left - right) * (high - low);
        const double at = along.dot(place.head<2>() - from);
        if (at > -on_it && at < length + on_it) vertex = add_vertex(place);
      }
      cuts[edge] = vertex;
      return vertex;
    };
    const Vec2 low = from.cwiseMin(to), high = from.cwiseMax(to);
    const std::size_t known = mesh_.triangles.size();
    for (std::size_t t = 0; t < known; ++t) {
      const std::array<int, 3> corner = mesh_.triangles[t];
      const Vec2 a = plan(corner[0]), b = plan(corner[1]), c = plan(corner[2]);
      if ((a.cwiseMin(b).cwiseMin(c).array() > high.array() + on_it).any() ||
          (a.cwiseMax(b).cwiseMax(c).array() < low.array() - on_it).any())
        continue;
      split(t, {cut_of(corner[0], corner[1]), cut_of(corner[1], corner[2]), cut_of(corner[2], corner[0])});
    }
  }

  /// Splits a triangle at the new vertices of its sides; -1: none. A line cuts at most two sides.
  void split(std::size_t t, const std::array<int, 3>& at) {
    const std::array<int, 3> corner = mesh_.triangles[t];
    const int part = mesh_.part[t];
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      if (at[k] >= 0 && at[next] < 0 && at[last] < 0) {
        mesh_.triangles[t] = {corner[k], at[k], corner[last]};
        add_triangle(at[k], corner[next], corner[last], part);
        return;
      }
      if (at[k] >= 0 && at[last] >= 0) {  // both sides at corner k
        mesh_.triangles[t] = {corner[k], at[k], at[last]};
        const double one = (mesh_.vertices[at[k]] - mesh_.vertices[corner[last]]).squaredNorm();
        const double other = (mesh_.vertices[corner[next]] - mesh_.vertices[at[last]]).squaredNorm();
        if (one < other) {
          add_triangle(at[k], corner[next], corner[last], part);
          add_triangle(at[k], corner[last], at[last], part);
        } else {
          add_triangle(at[k], corner[next], at[last], part);
          add_triangle(corner[next], corner[last], at[last], part);
        }
        return;
      }
    }
  }

  Mesh& mesh_;
};

Mesh square_of(const Plane& plane) {
  constexpr double half = 1000;  // m
  Mesh mesh;
  mesh.parts = plane.parts;
  for (const Vec2& step : {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)}) {
    const Vec2 at = plane.point.head<2>() + step;
    mesh.vertices.emplace_back(at.x(), at.y(), plane.height(at.x(), at.y()));
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.part = {0, 0};
  return mesh;
}

int new_part(std::vector<std::string>& parts, const std::string& name) {
  parts.push_back(name);
  return static_cast<int>(parts.size()) - 1;
}

void cover(Mesh& mesh, const std::string& name, const std::function<bool(const Vec2&)>& covers) {
  const int part = new_part(mesh.parts, name);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corner = mesh.triangles[t];
    const Vec3 middle = (mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]) / 3;
    if (covers(middle.head<2>())) mesh.part[t] = part;
  }
}

void cover(HeightGrid& grid, const std::string& name, const std::function<bool(const Vec2&)>& covers) {
  const auto part = static_cast<std::uint8_t>(new_part(grid.parts, name));
  if (grid.part.empty()) grid.part.assign(grid.heights.size(), 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (covers(grid.corner + grid.cell * Vec2(column, row)))
        grid.part[static_cast<std::size_t>(row) * grid.columns + column] = part;
}

}  // namespace

bool is_inside(const std::vector<Vec2>& polygon, const Vec2& place) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

bool is_inside(const std::vector<PlanPolygon>& polygons, const Vec2& place) {
  return std::any_of(polygons.begin(), polygons.end(), [&](const PlanPolygon& polygon) {
    const auto is_about = [&](const PlanRing& hole) { return is_inside(hole, place); };
    return is_inside(polygon.outline, place) &&
           std::none_of(polygon.holes.begin(), polygon.holes.end(), is_about);
  });
}

std::string polygon_fault(const std::vector<Vec2>& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return fmt::format("a polygon has {} corners, at least 3 are needed", n);
  double twice_area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n];
    if (a == b) return fmt::format("a polygon has the corner {} twice in a row", place_text(a));
    twice_area += cross(Vec2(a - polygon[0]), Vec2(b - polygon[0]));
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;  // neighbours
      if (stretches_meet(a, b, polygon[k], polygon[(k + 1) % n]))
        return fmt::format("the outline of a polygon crosses itself between {} and {}", place_text(a),
                           place_text(polygon[k]));
    }
  }
  return twice_area == 0 ? "a polygon has no area" : "";
}

TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name, const std::vector<Vec2>& polygon) {
  return with_zone(std::move(shape), name, std::vector<PlanPolygon>{{polygon, {}}});
}

TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name,
                        const std::vector<PlanPolygon>& polygons) {
  if (const Plane* plane = std::get_if<Plane>(&shape)) shape = square_of(*plane);
  if (Mesh* mesh = std::get_if<Mesh>(&shape))
    for (const PlanPolygon& polygon : polygons) {
      Cutter(*mesh).cut(polygon.outline);
      for (const PlanRing& hole : polygon.holes) Cutter(*mesh).cut(hole);
    }
  return with_zone(std::move(shape), name,
                   [&polygons](const Vec2& place) { return is_inside(polygons, place); });
}

TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name,
                        const std::function<bool(const Vec2&)>& covers) {
  if (const Plane* plane = std::get_if<Plane>(&shape)) shape = square_of(*plane);
  if (Mesh* mesh = std::get_if<Mesh>(&shape))
    cover(*mesh, name, covers);
  else
    cover(std::get<HeightGrid>(shape), name, covers);
  return shape;
}

}  // namespace flyrock
