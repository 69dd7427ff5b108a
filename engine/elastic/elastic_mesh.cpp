#include "elastic/elastic_mesh.h"

#include <cmath>

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
  return mesh;
}

double doubled_cell_area(const ElasticMesh<2>& mesh, const std::array<int, 3>& cell) {
  const Vec2 &a = mesh.nodes[cell[0]], &b = mesh.nodes[cell[1]], &c = mesh.nodes[cell[2]];
  return cross(b - a, c - a);
}

MeshSection section_of(const ElasticMesh<2>& mesh) {
  MeshSection section;
  for (const auto& cell : mesh.cells) {
    const double area = 0.5 * doubled_cell_area(mesh, cell);
    section.area += area;
    section.centre += area / 3 * (mesh.nodes[cell[0]] + mesh.nodes[cell[1]] + mesh.nodes[cell[2]]);
  }
  section.centre /= section.area;
  for (const auto& cell : mesh.cells) {
    // The integral of r.r over a triangle is area/12 (sum of squares of the corners + square of their sum).
    double squares = 0;
    Vec2 sum = Vec2::Zero();
    for (const int node : cell) {
      const Vec2 arm = mesh.nodes[node] - section.centre;
      squares += arm.squaredNorm();
      sum += arm;
    }
    section.polar_moment += 0.5 * doubled_cell_area(mesh, cell) / 12 * (squares + sum.squaredNorm());
  }
  return section;
}

}  // namespace flyrock
