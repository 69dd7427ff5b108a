#include "geometry/fill_hole.h"

#include <algorithm>
#include <limits>
#include <map>

#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"

namespace flyrock {

std::vector<std::vector<int>> holes_of(const Mesh& mesh) {
  const auto across = neighbours_of(mesh.triangles, sorted_sides(mesh.triangles));
  const MeshPieces pieces = pieces_of(across);
  std::vector<std::array<bool, 3>> visited(mesh.triangles.size(), {false, false, false});
  struct Border {
    std::vector<int> vertices;
    double size = 0;  ///< m, diagonal of its box
  };
  std::map<int, std::vector<Border>> borders;  // by piece
  for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed)
    for (int side = 0; side < 3; ++side) {
      if (across[seed][side] >= 0 || visited[seed][side]) continue;
      Border border;
      Vec3 low = Vec3::Constant(1e300), high = -low;
      for (int t = seed, k = side; !visited[t][k];) {
        visited[t][k] = true;
        const int vertex = mesh.triangles[t][k], end = mesh.triangles[t][(k + 1) % 3];
        border.vertices.push_back(vertex);
        low = low.cwiseMin(mesh.vertices[vertex]);
        high = high.cwiseMax(mesh.vertices[vertex]);
        for (k = (k + 1) % 3; across[t][k] >= 0;) {  // turns about the end through its fan
          t = across[t][k];
          for (k = 0; mesh.triangles[t][k] != end;) ++k;
        }
      }
      border.size = (high - low).norm();
      borders[pieces.of[seed]].push_back(std::move(border));
    }
  std::vector<std::vector<int>> holes;
  for (auto& [piece, list] : borders) {
    const auto longest = std::max_element(list.begin(), list.end(),
                                          [](const Border& a, const Border& b) { return a.size < b.size; });
    for (auto border = list.begin(); border != list.end(); ++border)
      if (border != longest) holes.push_back(std::move(border->vertices));
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
      least[i][j] = std::numeric_limits<double>::infinity();
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
