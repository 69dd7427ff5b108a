// Triangles without an area, which a mesh keeps its surface without.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/place_text.h"
#include "survey/mesh_draft.h"

namespace flyrock {

/// A pass may leave others flat, which the next one drops.
void MeshDraft::drop_flat() {
  const int before = triangles();
  std::vector<int> without_area;
  for (int t = 0; t < before; ++t)
    if (is_flat(t)) without_area.push_back(t);
  if (without_area.empty()) return;
  const std::string where = fmt::format("{}, the first with a corner at {}", lines_of(without_area),
                                        place_text(corner(without_area[0], 0)));
  join_equal_places(mesh_);
  constexpr int most_passes = 20;
  for (int pass = 0; pass < most_passes && drop_flat_once(); ++pass) {
  }
  mesh_ = welded(std::move(mesh_));
  notes_.push_back(fmt::format(
      "dropped {}{}", counted(without_area.size(), "triangle without an area", "triangles without an area"),
      where));
}

bool MeshDraft::drop_flat_once() {
  const Neighbours across = neighbours();
  const int known = triangles();
  std::vector<bool> gone(mesh_.triangles.size(), false), touched = gone;
  std::vector<int> joined(mesh_.vertices.size());
  std::iota(joined.begin(), joined.end(), 0);
  bool any = false, joins = false;
  for (int t = 0; t < known; ++t) {
    if (touched[t] || !is_flat(t)) continue;
    any = true;
    const auto [shortest, longest] = ends_of_sizes(t);
    const auto c = mesh_.triangles[t];
    const int a = c[shortest], b = c[(shortest + 1) % 3];
    if (a == b || c[(shortest + 2) % 3] == a) {
      gone[t] = touched[t] = true;
    } else if ((at(a) - at(b)).norm() < 2e-6) {  // has_area: such a side makes all triangles at it flat
      joined[std::max(a, b)] = std::min(a, b);
      joins = true;
      gone[t] = touched[t] = true;
    } else {
      const int other = across[t][longest];
      if (other >= 0 && touched[other]) continue;  // in the next pass
      gone[t] = touched[t] = true;
      if (other < 0) continue;
      touched[other] = true;
      int side = 0;
      while (mesh_.triangles[other][side] != c[(longest + 1) % 3]) side = (side + 1) % 3;
      if (mesh_.triangles[other][(side + 1) % 3] == c[longest]) {
        split_side(other, side, c[(longest + 2) % 3]);
        gone.push_back(false);
        touched.push_back(true);
      }
    }
  }
  if (joins)
    for (auto& triangle : mesh_.triangles)
      for (int& v : triangle)
        while (joined[v] != v) v = joined[v];
  erase(gone);
  return any;
}

/// The shortest and the longest side of a triangle.
std::pair<int, int> MeshDraft::ends_of_sizes(int t) const {
  double length[3];
  for (int k = 0; k < 3; ++k) length[k] = (corner(t, k + 1) - corner(t, k)).squaredNorm();
  return {static_cast<int>(std::min_element(length, length + 3) - length),
          static_cast<int>(std::max_element(length, length + 3) - length)};
}

}  // namespace flyrock
