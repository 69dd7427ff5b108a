#pragma once
// Meshes as surveys give them, with what exporters do to them, and the height of a mesh at a place by asking
// each of its triangles.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/mesh.h"
#include "random/stream.h"

namespace surveyed_meshes {

using namespace flyrock;

inline RandomStream dice(int seed) { return {static_cast<std::uint64_t>(seed), "surveyed meshes", {}}; }

/// A sheet of columns x rows cells of about `cell` m, each of two triangles, over random hills.
struct Sheet {
  int columns = 6, rows = 5;
  double cell = 2;
  Vec2 corner = Vec2::Zero();
  double slope_x = -0.4, slope_y = 0.1, hill = 1, phase = 0;

  double height(const Vec2& p) const {
    return 40 + slope_x * p.x() + slope_y * p.y() +
           hill * std::sin(0.31 * p.x() + phase) * std::cos(0.27 * p.y());
  }

  Mesh mesh() const {
    Mesh mesh;
    mesh.parts = {""};
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const Vec2 p = corner + cell * Vec2(i, j);
        mesh.vertices.emplace_back(p.x(), p.y(), height(p));
      }
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = a + columns + 1;
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    mesh.part.assign(mesh.triangles.size(), 0);
    return mesh;
  }
};

inline Sheet random_sheet(RandomStream& rng) {
  Sheet sheet;
  sheet.columns = static_cast<int>(rng.integer(3, 9));
  sheet.rows = static_cast<int>(rng.integer(3, 9));
  sheet.cell = rng.uniform(0.5, 8);
  sheet.corner = {std::round(rng.uniform(-50, 50)), std::round(rng.uniform(-50, 50))};
  sheet.slope_x = rng.uniform(-0.8, 0.8);
  sheet.slope_y = rng.uniform(-0.8, 0.8);
  sheet.hill = rng.uniform(0, 1);
  sheet.phase = rng.uniform(0, 6);
  return sheet;
}

/// Appends a mesh to another one.
inline void append(Mesh& mesh, const Mesh& more) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.part.push_back(0);
  }
}

inline void turn_over(Mesh& mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

/// The heights of all triangles above and below a place in plan, from the lowest.
inline std::vector<double> heights_at(const Mesh& mesh, const Vec2& p) {
  std::vector<double> heights;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const Vec2 u = (b - a).head<2>(), v = (c - a).head<2>(), w = p - a.head<2>();
    const double area = u.x() * v.y() - u.y() * v.x();
    if (std::abs(area) < 1e-9) continue;
    const double s = (w.x() * v.y() - w.y() * v.x()) / area, r = (u.x() * w.y() - u.y() * w.x()) / area;
    if (s < 0 || r < 0 || s + r > 1) continue;
    heights.push_back(a.z() + s * (b.z() - a.z()) + r * (c.z() - a.z()));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// A place in plan over a sheet, not on its outline.
inline Vec2 place_on(const Sheet& sheet, RandomStream& rng) {
  return sheet.corner +
         sheet.cell * Vec2(rng.uniform(0.01, 0.99) * sheet.columns, rng.uniform(0.01, 0.99) * sheet.rows);
}

}  // namespace surveyed_meshes
