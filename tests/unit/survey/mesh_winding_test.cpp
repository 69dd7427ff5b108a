// One side for triangles whose corners come in any order.

#include "survey/mesh_winding.h"

#include <catch2/catch.hpp>

#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "samples.h"
#include "surveyed_meshes.h"

using namespace flyrock;

namespace mesh_winding_test {

using namespace surveyed_meshes;

namespace {

/// Turns about half of the triangles, and gives each its own corners, as a file of faces has them.
Mesh shuffled(const Mesh& mesh, RandomStream& rng) {
  Mesh loose = mesh;
  loose.vertices.clear();
  for (auto& triangle : loose.triangles) {
    if (rng.uniform() < 0.5) std::swap(triangle[0], triangle[1]);
    for (int& corner : triangle) {
      loose.vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
      corner = static_cast<int>(loose.vertices.size()) - 1;
    }
  }
  return loose;
}

Vec3 normal(const Mesh& mesh, std::size_t t) {
  const auto& corners = mesh.triangles[t];
  const Vec3 a = mesh.vertices[static_cast<std::size_t>(corners[0])];
  return (mesh.vertices[static_cast<std::size_t>(corners[1])] - a)
      .cross(mesh.vertices[static_cast<std::size_t>(corners[2])] - a)
      .normalized();
}

/// Whether each triangle has its normal again.
bool has_normals_of(const Mesh& found, const Mesh& expected) {
  for (std::size_t t = 0; t < expected.triangles.size(); ++t)
    if ((normal(found, t) - normal(expected, t)).norm() > 1e-9) return false;
  return true;
}

void wind(Mesh& mesh) {
  join_equal_places(mesh);
  wind_alike(mesh);
}

/// A strip whose section runs forward, back below itself, and forward: a wall that hangs over.
Mesh overhang() {
  Mesh mesh;
  mesh.parts = {""};
  const Vec2 section[] = {{0, 10}, {6, 10}, {5, 4}, {6.5, 0}, {20, -1}};
  for (const Vec2& place : section)
    for (const double y : {0.0, 8.0}) mesh.vertices.emplace_back(place.x(), y, place.y());
  for (int i = 0; i < 8; i += 2)
    mesh.triangles.insert(mesh.triangles.end(), {{i, i + 2, i + 3}, {i, i + 3, i + 1}});
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// A tetrahedron with its normals outwards.
Mesh closed_piece() {
  Mesh mesh;
  mesh.parts = {""};
  mesh.vertices = {{100, 0, 0}, {103, 0, 0}, {100, 3, 0}, {100, 0, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  mesh.part.assign(4, 0);
  return mesh;
}

}  // namespace

TEST_CASE("triangles of sheets in any order of their corners look up again") {
  for (int seed = 0; seed < samples(100); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "winding", {});
    const Mesh made = random_sheet(rng).mesh();
    Mesh found = shuffled(made, rng);
    wind(found);
    CHECK(has_normals_of(found, made));
    CHECK(fault(welded(found)).empty());
  }
}

TEST_CASE("an overhang keeps the side of the ground, and a closed piece looks outwards") {
  for (int seed = 0; seed < samples(20); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "winding", {});
    for (const Mesh& made : {overhang(), closed_piece()}) {
      Mesh found = shuffled(made, rng);
      wind(found);
      CHECK(has_normals_of(found, made));
    }
  }
}

}  // namespace mesh_winding_test
