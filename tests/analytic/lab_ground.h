#pragma once
// Grounds in 3D for tests: one surface as a plane, as triangles and as a grid of heights.

#include <random>

#include "analytic/lab_3d.h"
#include "geometry/hull.h"

namespace flyrock::lab {

using Height = std::function<double(double x, double y)>;

inline Height height_of(const Plane& plane) {
  return [plane](double x, double y) { return plane.height(x, y); };
}

/// A square of side 2 `half` about the origin in n x n cells, each cut along a random diagonal. The inner
/// vertices are moved in plan by up to `jitter` of a cell.
inline Mesh mesh_of(const Height& height, double half, int n, double jitter = 0, unsigned seed = 1) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> random(-1, 1);
  const double cell = 2 * half / n;
  Mesh mesh;
  mesh.parts = {""};
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) {
      double x = -half + c * cell, y = -half + r * cell;
      if (c > 0 && c < n) x += jitter * cell * random(rng);
      if (r > 0 && r < n) y += jitter * cell * random(rng);
      mesh.vertices.push_back({x, y, height(x, y)});
    }
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      const int sw = r * (n + 1) + c, se = sw + 1, nw = sw + n + 1, ne = nw + 1;
      if (random(rng) < 0) {
        mesh.triangles.push_back({sw, se, ne});
        mesh.triangles.push_back({sw, ne, nw});
      } else {
        mesh.triangles.push_back({sw, se, nw});
        mesh.triangles.push_back({se, ne, nw});
      }
    }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

inline HeightGrid grid_of(const Height& height, double half, int n) {
  HeightGrid grid;
  grid.columns = grid.rows = n + 1;
  grid.cell = 2 * half / n;
  grid.corner = {-half, -half};
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) grid.heights.push_back(height(-half + c * grid.cell, -half + r * grid.cell));
  return grid;
}

/// A profile in the plane y = 0, extended along y from -half to half in n strips.
inline Mesh extruded(const Profile& profile, double half, int n) {
  Mesh mesh;
  mesh.parts = {""};
  const int across = static_cast<int>(profile.points.size());
  for (int r = 0; r <= n; ++r)
    for (const Vec2& p : profile.points) mesh.vertices.push_back({p.x(), half * (2.0 * r / n - 1), p.y()});
  for (int r = 0; r < n; ++r)
    for (int c = 0; c + 1 < across; ++c) {
      const int a = r * across + c;
      mesh.triangles.push_back({a, a + 1, a + across + 1});
      mesh.triangles.push_back({a, a + across + 1, a + across});
    }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// Hills and pits of all sizes down to a cell of 0.5 m, on a slope that falls towards +x.
inline Height rough(unsigned seed, double amplitude, double fall = 0.3) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> random(-1, 1);
  struct Wave {
    double kx, ky, phase, height;
  };
  std::vector<Wave> waves;
  for (double length = 16; length > 0.9; length /= 1.5)
    for (int i = 0; i < 3; ++i) {
      const double turn = pi * random(rng), k = 2 * pi / length;
      waves.push_back({k * std::cos(turn), k * std::sin(turn), pi * random(rng),
                       amplitude * std::pow(length / 16, 0.9) * random(rng)});
    }
  return [waves, fall](double x, double y) {
    double z = -fall * x;
    for (const Wave& w : waves) z += w.height * std::sin(w.kx * x + w.ky * y + w.phase);
    return z;
  };
}

/// A closed block, 12 m x 12 m, with the hilly top of mesh_of and a flat bottom.
inline Mesh hilly_block() {
  constexpr double half = 6, bottom = -8;
  Mesh mesh = mesh_of(rough(5, 0.5, 0.2), half, 12, 0.2);
  const int n = 12, top = static_cast<int>(mesh.vertices.size());
  std::vector<int> rim;  // counter-clockwise as seen from above
  for (int i = 0; i < n; ++i) rim.push_back(i);
  for (int i = 0; i < n; ++i) rim.push_back(i * (n + 1) + n);
  for (int i = n; i > 0; --i) rim.push_back(n * (n + 1) + i);
  for (int i = n; i > 0; --i) rim.push_back(i * (n + 1));
  for (const int i : rim) mesh.vertices.emplace_back(mesh.vertices[i].x(), mesh.vertices[i].y(), bottom);
  const int count = static_cast<int>(rim.size()), middle = top + count;
  mesh.vertices.emplace_back(0, 0, bottom);
  for (int i = 0; i < count; ++i) {
    const int j = (i + 1) % count;
    mesh.triangles.push_back({rim[j], rim[i], top + i});
    mesh.triangles.push_back({rim[j], top + i, top + j});
    mesh.triangles.push_back({top + j, top + i, middle});
  }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

inline Mesh turned_about_z(Mesh mesh, double angle) {
  const Rotation3 turn = Rotation3::from_vector({0, 0, angle});
  for (Vec3& v : mesh.vertices) v = turn * v;
  return mesh;
}

/// The convex hull of random points on an ellipsoid of about the given radius.
inline Body<3> rock(unsigned seed, double radius, int points = 14) {
  std::mt19937 rng(seed);
  std::normal_distribution<double> random;
  std::vector<Vec3> corners;
  for (int i = 0; i < points; ++i) {
    const Vec3 direction = Vec3(random(rng), random(rng), random(rng)).normalized();
    corners.push_back(radius * direction.cwiseProduct(Vec3(1.2, 1, 0.8)));
  }
  return make_body({convex_hull(corners)}, 2700, 0);
}

/// A sphere (0), a box (1) or a polyhedron (2) of about the given radius at the origin, at rest.
inline Body<3> body_of_kind(int kind, double radius, unsigned seed = 1) {
  if (kind == 0) return make_body({Contactor3::sphere(radius)}, 2700, 0);
  if (kind == 1) return make_body({Contactor3::box(radius * Vec3(1.5, 1.1, 0.9))}, 2700, 0);
  return rock(seed, radius);
}

/// The first impacts agree in time, place and speeds.
/// `turn` takes the places of `a` to those of `b`.
inline void check_equal(const std::vector<Impact>& a, const std::vector<Impact>& b, std::size_t count,
                        double margin, const Rotation3& turn = {}) {
  REQUIRE(a.size() >= count);
  REQUIRE(b.size() >= count);
  for (std::size_t i = 0; i < count; ++i) {
    CAPTURE(i);
    CHECK(std::abs(a[i].time - b[i].time) < margin);
    CHECK((turn * a[i].place - b[i].place).norm() < margin);
    CHECK(std::abs(a[i].vn_before - b[i].vn_before) < margin);
    CHECK(std::abs(a[i].vn_after - b[i].vn_after) < margin);
    CHECK(std::abs(a[i].vt_before - b[i].vt_before) < margin);
    CHECK(std::abs(a[i].vt_after - b[i].vt_after) < margin);
  }
}

}  // namespace flyrock::lab
