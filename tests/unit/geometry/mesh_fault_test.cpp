// Which meshes are no ground, and how equal places become one vertex.

#include "geometry/mesh_fault.h"

#include <catch2/catch.hpp>
#include <limits>

#include "geometry/mesh_edges.h"

using namespace flyrock;

namespace {

Mesh mesh_of(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles) {
  Mesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  mesh.part.assign(mesh.triangles.size(), 0);
  mesh.parts = {""};
  return mesh;
}

/// A level square of n x n cells of 1 m, two triangles each, without the cells that `left_out` names.
Mesh level_mesh(int n, const std::vector<std::pair<int, int>>& left_out = {}) {
  Mesh mesh = mesh_of({}, {});
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.vertices.emplace_back(i, j, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (std::find(left_out.begin(), left_out.end(), std::pair(i, j)) != left_out.end()) continue;
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// A pyramid on the corners of a square, all faces outwards.
Mesh pyramid() {
  return mesh_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}},
                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}});
}

}  // namespace

TEST_CASE("a surface with one border, an overhang and a closed rock are ground") {
  CHECK(fault(level_mesh(4)).empty());
  CHECK(fault(pyramid()).empty());
  const Mesh overhang =
      mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {-1, 0, 3}, {-1, 4, 3}, {-5, 0, 3}, {-5, 4, 3}},
              {{0, 1, 2}, {0, 2, 3}, {4, 0, 3}, {4, 3, 5}, {6, 4, 5}, {6, 5, 7}});
  CHECK(fault(overhang).empty());
}

TEST_CASE("a mesh that is no ground says what is wrong, and where") {
  CHECK(fault(mesh_of({}, {})) == "a mesh has no triangles");
  CHECK(fault(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}), {7}) ==
        "triangle 0 in line 7 of a mesh names the vertex 3 of 3 vertices (from 0)");
  CHECK(fault(mesh_of({{0, 0, 0}, {1, 0, std::numeric_limits<double>::quiet_NaN()}, {0, 1, 0}},
                      {{0, 1, 2}})) == "a vertex of triangle 0 of a mesh is not finite");
  CHECK(fault(mesh_of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}), {9}) ==
        "the triangle (0, 0, 0), (1, 0, 0), (3, 0, 0) in line 9 has no area: it is 3 m long and 0 m high, "
        "expected a height above 1e-06 m and above 1e-06 of its length");
  CHECK(fault(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}},
                      {{0, 1, 3}, {0, 3, 2}, {3, 0, 4}}),
              {1, 2, 3}) ==
        "the edge from (0, 0, 0) to (1, 1, 0) has 3 triangles (lines 1, 2, 3), expected one or two");
  Mesh parts = level_mesh(1);
  parts.part = {0, 1};
  CHECK(fault(parts) == "a mesh of 1 parts has a triangle of part 1");
  parts.part = {0};
  CHECK(fault(parts) == "the mesh has 2 triangles but 1 part numbers");
}

TEST_CASE("a flipped neighbour is named by its edge") {
  Mesh mesh = level_mesh(3);
  std::swap(mesh.triangles[8][0], mesh.triangles[8][1]);
  std::vector<int> lines(mesh.triangles.size());
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = 100 + static_cast<int>(i);
  CHECK(fault(mesh, lines) ==
        "the two triangles at the edge from (1, 1, 0) to (2, 1, 0) (lines 103 and 108) face opposite ways, "
        "and so at 2 "
        "other edges; expected the corners of all triangles counter-clockwise, seen from outside of the "
        "ground");
}

TEST_CASE("a mesh that faces down is refused, and one that stands upright") {
  Mesh down = level_mesh(2);
  for (auto& triangle : down.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(
      fault(down).find(
          "the piece of 8 triangles with the triangle (1, 0, 0), (0, 0, 0), (1, 1, 0) faces down: it has the "
          "ground above it") == 0);
  CHECK(fault(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}})).find("faces down or stands upright") !=
        std::string::npos);
  Mesh inwards = pyramid();
  for (auto& triangle : inwards.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(fault(inwards).find("is closed and faces inwards") != std::string::npos);
}

TEST_CASE("a hole inside is refused with its place, a bay at the border is not") {
  CHECK(fault(level_mesh(5, {{2, 2}})) ==
        "the mesh has a hole of 4 edges from (2, 2, 0) to (3, 3, 0); expected ground without holes inside");
  CHECK(fault(level_mesh(7, {{2, 2}, {4, 4}, {5, 4}})) ==
        "the mesh has a hole of 6 edges from (4, 4, 0) to (6, 5, 0), and 1 more; expected ground without "
        "holes inside");
  CHECK(fault(level_mesh(5, {{4, 2}})).empty());
  CHECK(fault(welded(level_mesh(5, {{4, 4}, {3, 3}})))
            .empty());  // the two missing cells touch, and so open to the border
}

TEST_CASE("equal places become one vertex, fans that only touch get their own") {
  // Two triangles of a file that repeats the corners, such as STL.
  const Mesh square = welded(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK(square.vertices.size() == 4);
  CHECK(square.triangles[1][0] == square.triangles[0][0]);
  CHECK(neighbours_of(square.triangles, sorted_sides(square.triangles))[0][2] == 1);
  // Two triangles that share a corner only.
  const Mesh bow = welded(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}}, {{0, 1, 2}, {0, 3, 4}}));
  CHECK(bow.vertices.size() == 6);
  CHECK(bow.triangles[0][0] != bow.triangles[1][0]);
  CHECK(bow.vertices[bow.triangles[1][0]] == Vec3(0, 0, 0));
}
