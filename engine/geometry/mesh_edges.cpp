#include "geometry/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace flyrock {

std::vector<MeshSide> sorted_sides(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<MeshSide> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const MeshSide& a, const MeshSide& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
  return sides;
}

std::vector<std::array<int, 3>> neighbours_of(const std::vector<std::array<int, 3>>& triangles,
                                              const std::vector<MeshSide>& sides) {
  std::vector<std::array<int, 3>> across(triangles.size(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const MeshSide &a = sides[i], &b = sides[i + 1];
    if (!a.same_edge(b)) continue;
    across[a.triangle][a.side] = b.triangle;
    across[b.triangle][b.side] = a.triangle;
    while (i + 1 < sides.size() && sides[i + 1].same_edge(a)) ++i;
  }
  return across;
}

void join_equal_places(Mesh& mesh) {
  std::vector<int> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    const Vec3& p = mesh.vertices[i];
    return std::make_tuple(p.x(), p.y(), p.z(), i);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  std::vector<int> joined(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
    joined[order[i]] = repeats ? joined[order[i - 1]] : order[i];
  }
  for (auto& triangle : mesh.triangles)
    for (int& corner : triangle) corner = joined[corner];
}

namespace {

/// Repeats a vertex for each fan of triangles about it after the first.
void part_fans(Mesh& mesh) {
  auto& triangles = mesh.triangles;
  const auto across = neighbours_of(triangles, sorted_sides(triangles));
  const int known = static_cast<int>(mesh.vertices.size());
  std::vector<bool> has_fan(known, false);
  std::vector<std::array<bool, 3>> seen(triangles.size(), {false, false, false});
  std::vector<std::pair<int, int>> fan;  // triangle and corner
  const auto corner_of = [&](int triangle, int vertex) {
    for (int k = 0; k < 3; ++k)
      if (triangles[triangle][k] == vertex) return k;
    return -1;
  };
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (seen[t][k]) continue;
      const int vertex = triangles[t][k];
      fan.assign(1, {t, k});
      seen[t][k] = true;
      for (std::size_t next = 0; next < fan.size(); ++next) {
        const auto [triangle, corner] = fan[next];
        for (const int side : {corner, (corner + 2) % 3}) {
          const int other = across[triangle][side];
          const int place = other < 0 ? -1 : corner_of(other, vertex);
          if (place < 0 || seen[other][place]) continue;
          seen[other][place] = true;
          fan.emplace_back(other, place);
        }
      }
      if (!has_fan[vertex]) {
        has_fan[vertex] = true;
        continue;
      }
      const Vec3 place = mesh.vertices[vertex];
      mesh.vertices.push_back(place);
      for (const auto& [triangle, corner] : fan)
        triangles[triangle][corner] = static_cast<int>(mesh.vertices.size()) - 1;
    }
  }
}

void drop_unused_vertices(Mesh& mesh) {
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) number[corner] = 0;
  int count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    mesh.vertices[count] = mesh.vertices[i];
    number[i] = count++;
  }
  mesh.vertices.resize(count);
  for (auto& triangle : mesh.triangles)
    for (int& corner : triangle) corner = number[corner];
}

}  // namespace

Mesh welded(Mesh mesh) {
  join_equal_places(mesh);
  part_fans(mesh);
  drop_unused_vertices(mesh);
  return mesh;
}

}  // namespace flyrock
