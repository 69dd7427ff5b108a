// Triangles that stand twice in a mesh.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "survey/mesh_draft.h"

namespace flyrock {

/// Keeps one of the triangles that have the same corners: of two that face opposite ways, as files for
/// drawing have them, the one that looks up.
void MeshDraft::drop_twins() {
  Mesh joined = mesh_;  // twins meet others at edges of more than two triangles, where vertices are repeated
  join_equal_places(joined);
  for (auto& triangle : joined.triangles) std::sort(triangle.begin(), triangle.end());
  const auto corners = [&joined](int t) -> const std::array<int, 3>& { return joined.triangles[t]; };
  std::vector<int> order(mesh_.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return corners(a) < corners(b); });
  std::vector<int> dropped;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    int kept = order[i];
    for (end = i + 1; end < order.size() && corners(order[end]) == corners(order[i]); ++end) {
      int other = order[end];
      if (twice_area(other).z() > twice_area(kept).z()) std::swap(kept, other);
      dropped.push_back(other);
    }
  }
  if (dropped.empty()) return;
  std::sort(dropped.begin(), dropped.end());
  drop(dropped, fmt::format("dropped {} with the corners of another one{}",
                            counted(dropped.size(), "triangle", "triangles"), lines_of(dropped)));
}

}  // namespace flyrock
