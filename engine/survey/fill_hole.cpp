#include "survey/fill_hole.h"

#include <algorithm>
#include <map>

#include "geometry/mesh_border.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"

namespace flyrock {

std::vector<std::vector<int>> holes_of(const Mesh& mesh) {
  const auto across = neighbours_of(mesh.triangles, sorted_sides(mesh.triangles));
  const MeshPieces pieces = pieces_of(across);
  std::map<int, std::vector<MeshBorder>> borders;  // by piece
  for (MeshBorder& border : borders_of(mesh, across))
    borders[pieces.of[border.triangle]].push_back(std::move(border));
  std::vector<std::vector<int>> holes;
  for (auto& [piece, list] : borders) {
    take_end(list);
    for (MeshBorder& hole : list) holes.push_back(std::move(hole.vertices));
  }
  return holes;
}

std::vector<std::array<int, 3>> fill_hole(const std::vector<Vec3>& vertices, const std::vector<int>& border) {
  const std::vector<int> around(border.rbegin(), border.rend());  // the other way round than the triangles
  const int n = static_cast<int>(around.size());
  const auto area = [&](int i, int k, int j) {
    const Vec3 &a = vertices[around[i]], &b = vertices[around[k]], &c = vertices[around[j]];
    return has_area(a, b, c) ? 0.5 * (b - a).cross(c - a).norm() : 1e12;
  };
  std::vector<std::vector<double>> least(n, std::vector<double>(n, 0));  // area of the polygon from i to j
  std::vector<std::vector<int>> middle(n, std::vector<int>(n, -1));
  for (int length = 2; length < n; ++length)
    for (int i = 0; i + length < n; ++i) {
      const int j = i + length;
      least[i][j] = infinite;
      for (int k = i + 1; k < j; ++k) {
        const double sum = least[i][k] + least[k][j] + area(i, k, j);
        if (sum >= least[i][j]) continue;
        least[i][j] = sum;
        middle[i][j] = k;
      }
    }
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::pair<int, int>> open = {{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const int k = middle[i][j];
    triangles.push_back({around[i], around[k], around[j]});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

}  // namespace flyrock
