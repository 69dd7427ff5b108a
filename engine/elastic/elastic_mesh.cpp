#include "elastic/elastic_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flyrock {

ElasticMesh<2> crossed_rectangle(const Vec2& size, const std::array<int, 2>& cells) {
  ElasticMesh<2> mesh;
  const auto [columns, rows] = cells;
  const Vec2 quad(size.x() / columns, size.y() / rows);
  const auto corner = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.nodes.emplace_back(Vec2(i, j).cwiseProduct(quad) - 0.5 * size);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::array<int, 4> round{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      const int middle = static_cast<int>(mesh.nodes.size());
      mesh.nodes.emplace_back(Vec2(i + 0.5, j + 0.5).cwiseProduct(quad) - 0.5 * size);
      for (std::size_t k = 0; k < 4; ++k) mesh.cells.push_back({round[k], round[(k + 1) % 4], middle});
    }
  for (int i = 0; i < columns; ++i) mesh.surface.push_back(corner(i, 0));
  for (int j = 0; j < rows; ++j) mesh.surface.push_back(corner(columns, j));
  for (int i = columns; i > 0; --i) mesh.surface.push_back(corner(i, rows));
  for (int j = rows; j > 0; --j) mesh.surface.push_back(corner(0, j));
  find_surface(mesh);
  return mesh;
}

ElasticMesh<2> ringed_disk(double radius, int rings) {
  constexpr int sectors = 6;
  ElasticMesh<2> mesh;
  mesh.nodes.emplace_back(Vec2::Zero());
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < sectors * ring; ++i) {
      const double angle = 2 * pi * i / (sectors * ring);
      mesh.nodes.emplace_back(radius * ring / rings * Vec2(std::cos(angle), std::sin(angle)));
    }
  const auto node = [](int ring, int i) {
    return ring == 0 ? 0 : 1 + sectors / 2 * ring * (ring - 1) + i % (sectors * ring);
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector)
      for (int k = 0; k < ring; ++k) {
        const int outer = sector * ring + k, inner = sector * (ring - 1) + k;
        mesh.cells.push_back({node(ring, outer), node(ring, outer + 1), node(ring - 1, inner)});
        if (k + 1 < ring)
          mesh.cells.push_back({node(ring - 1, inner), node(ring, outer + 1), node(ring - 1, inner + 1)});
      }
  for (int i = 0; i < sectors * rings; ++i) mesh.surface.push_back(node(rings, i));
  find_surface(mesh);
  return mesh;
}

ElasticMesh<3> bricked_box(const Vec3& size, const std::array<int, 3>& cells) {
  ElasticMesh<3> mesh;
  const Vec3 brick = size.cwiseQuotient(Vec3(cells[0], cells[1], cells[2]));
  const auto node = [&](int i, int j, int k) { return (k * (cells[1] + 1) + j) * (cells[0] + 1) + i; };
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i)
        mesh.nodes.emplace_back(Vec3(i, j, k).cwiseProduct(brick) - 0.5 * size);
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) {
        // The corners a, b, c, d of the tetrahedron in the middle, and the one opposite to each.
        const int odd = (i + j + k) % 2;
        const auto corner = [&](int x, int y, int z) { return node(odd ? i + 1 - x : i + x, j + y, k + z); };
        const int a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(1, 0, 1), d = corner(0, 1, 1);
        for (ElasticMesh<3>::Cell cell : {ElasticMesh<3>::Cell{a, b, d, c},
                                          {corner(1, 1, 1), b, c, d},
                                          {corner(0, 0, 1), a, d, c},
                                          {corner(0, 1, 0), a, b, d},
                                          {corner(1, 0, 0), a, c, b}}) {
          if (odd) std::swap(cell[2], cell[3]);
          mesh.cells.push_back(cell);
        }
      }
  find_surface(mesh);
  return mesh;
}

template <int D>
std::vector<std::array<int, D>> outer_sides(const std::vector<std::array<int, D + 1>>& cells) {
  // The side opposite to each corner, its nodes in an order that shows its outside.
  std::vector<std::array<int, D>> sides;
  std::map<std::array<int, D>, int> count;
  const auto sorted = [](std::array<int, D> side) {
    std::sort(side.begin(), side.end());
    return side;
  };
  for (const auto& cell : cells)
    for (int opposite = 0; opposite <= D; ++opposite) {
      std::array<int, D> side{};
      for (int k = 0; k < D; ++k) side[k] = cell[(opposite + 1 + k) % (D + 1)];
      if (D == 3 && opposite % 2 == 1) std::swap(side[1], side[2]);
      sides.push_back(side);
      ++count[sorted(side)];
    }
  std::erase_if(sides, [&](const std::array<int, D>& side) { return count.at(sorted(side)) > 1; });
  return sides;
}

template <int D>
void find_surface(ElasticMesh<D>& mesh) {
  mesh.sides = outer_sides<D>(mesh.cells);
  if (D == 2) return;  // the outline is known
  for (const auto& side : mesh.sides) mesh.surface.insert(mesh.surface.end(), side.begin(), side.end());
  std::sort(mesh.surface.begin(), mesh.surface.end());
  mesh.surface.erase(std::unique(mesh.surface.begin(), mesh.surface.end()), mesh.surface.end());
}

double cell_determinant(const ElasticMesh<2>& mesh, const std::array<int, 3>& cell) {
  const Vec2 &a = mesh.nodes[cell[0]], &b = mesh.nodes[cell[1]], &c = mesh.nodes[cell[2]];
  return cross(b - a, c - a);
}

double cell_determinant(const ElasticMesh<3>& mesh, const std::array<int, 4>& cell) {
  const Vec3& a = mesh.nodes[cell[0]];
  return (mesh.nodes[cell[1]] - a).cross(mesh.nodes[cell[2]] - a).dot(mesh.nodes[cell[3]] - a);
}

template <int D>
MeshMoments<D> moments_of(const ElasticMesh<D>& mesh) {
  MeshMoments<D> moments;
  for (const auto& cell : mesh.cells) {
    const double volume = cell_volume(mesh, cell);
    Vec<D> sum = Vec<D>::Zero();
    for (const int node : cell) sum += mesh.nodes[node];
    moments.volume += volume;
    moments.centre += volume / (D + 1) * sum;
  }
  moments.centre /= moments.volume;
  for (const auto& cell : mesh.cells) {
    // The integral of r r^T over a simplex is V/((D+1)(D+2)) (sum over the corners of r r^T + s s^T), s the
    // sum of the corners.
    Eigen::Matrix<double, D, D> squares = Eigen::Matrix<double, D, D>::Zero();
    Vec<D> sum = Vec<D>::Zero();
    for (const int node : cell) {
      const Vec<D> arm = mesh.nodes[node] - moments.centre;
      squares += arm * arm.transpose();
      sum += arm;
    }
    moments.spread += cell_volume(mesh, cell) / ((D + 1) * (D + 2)) * (squares + sum * sum.transpose());
  }
  return moments;
}

#define FLYROCK_INSTANTIATE(D)                                                                         \
  template std::vector<std::array<int, D>> outer_sides<D>(const std::vector<std::array<int, D + 1>>&); \
  template void find_surface(ElasticMesh<D>&);                                                         \
  template MeshMoments<D> moments_of(const ElasticMesh<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
