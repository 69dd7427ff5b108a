// Borders of a mesh that nearly touch, and are joined.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "survey/mesh_draft.h"

namespace flyrock {

void MeshDraft::weld(double width) {
  const std::size_t joined = join_border_vertices(width), split = split_border_edges(width);
  if (joined + split == 0) return;
  drop_flat_after_weld();
  mesh_ = welded(std::move(mesh_));
  notes_.push_back(fmt::format(
      "welded {} within {:.3g} m{}", counted(joined, "vertex", "vertices"), width,
      split == 0 ? "" : fmt::format(" and {} to vertices near them", counted(split, "edge", "edges"))));
}

void MeshDraft::drop_flat_after_weld() {
  const std::size_t notes = notes_.size();
  drop_flat();
  notes_.resize(notes);  // the weld says it
}

std::vector<int> MeshDraft::border_vertices(const Neighbours& across) const {
  std::set<int> border;
  for (int t = 0; t < triangles(); ++t)
    for (int k = 0; k < 3; ++k)
      if (across[t][k] < 0) border.insert({mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]});
  return {border.begin(), border.end()};
}

/// Each vertex of a border goes to the nearest earlier one within `width`, which itself stays.
std::size_t MeshDraft::join_border_vertices(double width) {
  const std::vector<int> border = border_vertices(neighbours());
  PlanCellsOf<int> cells(4 * width);
  for (const int v : border) cells.add(at(v).head<2>(), at(v).head<2>(), v);
  cells.sort();
  std::vector<int> joined(mesh_.vertices.size());
  std::iota(joined.begin(), joined.end(), 0);
  std::size_t count = 0;
  for (const int v : border) {
    double least = width;
    const Vec2 place = at(v).head<2>(), reach = Vec2::Constant(width);
    int nearest = v;
    cells.visit(place - reach, place + reach, [&](int other) {
      if (other >= v || joined[other] != other) return;
      const double distance = (at(other) - at(v)).norm();
      if (distance > least || (distance == least && nearest != v && other >= nearest)) return;
      least = distance;
      nearest = other;
    });
    joined[v] = nearest;
    count += nearest != v && at(nearest) != at(v);
  }
  for (auto& triangle : mesh_.triangles)
    for (int& v : triangle) v = joined[v];
  return count;
}

/// Splits each edge of a border at the vertices of borders within `width` of it, one a pass.
std::size_t MeshDraft::split_border_edges(double width) {
  std::size_t count = 0;
  for (std::size_t before = 1; before > 0; count += before) before = split_once(width);
  return count;
}

std::size_t MeshDraft::split_once(double width) {
  const Neighbours across = neighbours();
  const std::vector<int> border = border_vertices(across);
  double sum = 0;
  std::vector<std::pair<int, int>> edges;
  for (int t = 0; t < triangles(); ++t)
    for (int k = 0; k < 3; ++k)
      if (across[t][k] < 0) {
        edges.emplace_back(t, k);
        sum += (corner(t, k + 1) - corner(t, k)).norm();
      }
  if (edges.empty()) return 0;
  PlanCellsOf<int> cells(std::max(2 * width, sum / static_cast<double>(edges.size())));
  for (const int v : border) cells.add(at(v).head<2>(), at(v).head<2>(), v);
  cells.sort();
  std::vector<bool> touched(mesh_.triangles.size(), false);
  std::size_t count = 0;
  for (const auto& [t, k] : edges) {
    if (touched[t]) continue;
    const int vertex = vertex_on(t, k, width, cells);
    if (vertex < 0) continue;
    touched[t] = true;
    split_side(t, k, vertex);
    ++count;
  }
  return count;
}

/// The vertex nearest to a side, within `width` of it and not near its ends; -1: none.
int MeshDraft::vertex_on(int t, int k, double width, const PlanCellsOf<int>& cells) const {
  const Vec3 &a = corner(t, k), &b = corner(t, k + 1);
  const auto& own = mesh_.triangles[t];
  const double length = (b - a).norm();
  const Vec2 reach = Vec2::Constant(width);
  double least = width;
  int nearest = -1;
  cells.visit(a.cwiseMin(b).head<2>() - reach, a.cwiseMax(b).head<2>() + reach, [&](int v) {
    if (v == own[0] || v == own[1] || v == own[2]) return;
    const double along = (at(v) - a).dot(b - a) / length;
    if (along < width || along > length - width) return;
    const double away = (at(v) - a - along / length * (b - a)).norm();
    if (away > least || (away == least && nearest >= 0 && v >= nearest)) return;
    if (!has_area(a, at(v), corner(t, k + 2)) || !has_area(at(v), b, corner(t, k + 2))) return;
    least = away;
    nearest = v;
  });
  return nearest;
}

}  // namespace flyrock
