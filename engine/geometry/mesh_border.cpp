#include "geometry/mesh_border.h"

#include <algorithm>

namespace flyrock {

namespace {

/// From a side at the border to the one that follows it: turns about its end through the fan.
void go_on(const Mesh& mesh, const std::vector<std::array<int, 3>>& across, int& triangle, int& side) {
  side = (side + 1) % 3;
  const int end = mesh.triangles[triangle][side];
  while (across[triangle][side] >= 0) {
    triangle = across[triangle][side];
    side = 0;
    while (mesh.triangles[triangle][side] != end) ++side;
  }
}

}  // namespace

std::vector<MeshBorder> borders_of(const Mesh& mesh, const std::vector<std::array<int, 3>>& across) {
  std::vector<MeshBorder> borders;
  std::vector<std::array<bool, 3>> visited(mesh.triangles.size(), {false, false, false});
  for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed)
    for (int first = 0; first < 3; ++first) {
      if (across[seed][first] >= 0 || visited[seed][first]) continue;
      MeshBorder border;
      border.triangle = seed;
      for (int triangle = seed, side = first; !visited[triangle][side];) {
        visited[triangle][side] = true;
        const int vertex = mesh.triangles[triangle][side];
        border.vertices.push_back(vertex);
        border.box.add(mesh.vertices[vertex]);
        go_on(mesh, across, triangle, side);
      }
      borders.push_back(std::move(border));
    }
  return borders;
}

void take_end(std::vector<MeshBorder>& borders) {
  const auto longest =
      std::max_element(borders.begin(), borders.end(),
                       [](const MeshBorder& a, const MeshBorder& b) { return a.size() < b.size(); });
  if (longest != borders.end()) borders.erase(longest);
}

}  // namespace flyrock
