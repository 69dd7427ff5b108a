// Where a terrain in 3D lies, and the profiles that are cut out of it.

#include "geometry/terrain_place.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

namespace {

Mesh slope_mesh() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 4}, {10, 0, 2}, {10, 10, 2}, {0, 10, 4}, {20, 0, 2}, {20, 10, 2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  mesh.part = {0, 0, 1, 1};
  mesh.parts = {"face", "floor"};
  return mesh;
}

HeightGrid hill() {
  HeightGrid grid;
  grid.columns = 11;
  grid.rows = 6;
  grid.cell = 2;
  grid.corner = {-10, -5};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      grid.heights.push_back(3 - 0.1 * std::abs(column - 5) * 2);
  return grid;
}

std::string section_error(const TerrainShape3& shape, const Vec2& from, const Vec2& to) {
  try {
    section_of(shape, from, to);
  } catch (const SectionError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("an origin is the lower left corner in the coordinates beyond 10 km, rounded down to 100 m") {
  Mesh mesh = slope_mesh();
  CHECK(automatic_origin(mesh) == Vec3(0, 0, 0));
  for (Vec3& vertex : mesh.vertices) vertex += Vec3(2600050, -1200050, 500);
  CHECK(automatic_origin(mesh) == Vec3(2600000, -1200100, 0));
  const Mesh near = std::get<Mesh>(counted_from(mesh, {2600000, -1200100, 0}));
  CHECK(near.vertices[0] == Vec3(50, 50, 504));
  HeightGrid grid = hill();
  grid.corner = {891318.69, 328987.38};
  CHECK(automatic_origin(grid) == Vec3(891300, 328900, 0));
  CHECK(automatic_origin(Plane{}) == Vec3(0, 0, 0));
}

TEST_CASE(
    "a terrain that reaches more than 100 km from its origin says so in the coordinates of the scenario") {
  Mesh mesh = slope_mesh();
  CHECK(reach_fault(mesh, {0, 0, 0}, 1e5).empty());
  mesh.vertices[1].x() = 200000;
  CHECK(reach_fault(mesh, {1000, 0, 0}, 1e5) ==
        "reaches to (201000, 10, 4), more than 100 km from the origin (1000, 0, 0)");
}

TEST_CASE("a section is a profile with the parts on its line") {
  for (const double y : {1.0, 5.0, 9.5}) {
    const Profile profile = section_of(slope_mesh(), {0, y}, {20, y});
    CHECK(profile.fault().empty());
    REQUIRE(profile.points.size() == 3);
    CHECK((profile.points[1] - Vec2(10, 2)).norm() < 1e-9);
    CHECK(profile.part == std::vector<int>{0, 1});
  }
  // Along the border and along edges, and backwards at an angle.
  CHECK(section_of(slope_mesh(), {0, 0}, {20, 0}).height(5) == Approx(3));
  CHECK(section_of(slope_mesh(), {20, 5}, {0, 5}).height(15) == Approx(3));
  const Profile across = section_of(slope_mesh(), {2, 1}, {18, 9});
  CHECK(across.x_max() == Approx(std::sqrt(16.0 * 16 + 8 * 8)));
  CHECK(across.height(across.x_max() / 4) == Approx(4 - 0.2 * 6));
}

TEST_CASE("a section of heights follows their triangles") {
  const Profile profile = section_of(hill(), {-9, 0}, {9, 0.5});
  CHECK(profile.fault().empty());
  CHECK(profile.height(profile.x_max() / 2) == Approx(3).margin(1e-9));
  CHECK(profile.height(0) == Approx(2.1).margin(1e-9));
  CHECK(profile.points.size() == 3);  // even slopes have no points inside
}

TEST_CASE("a section of a plane is a line, a section beyond the ground or through an overhang is an error") {
  Plane plane;
  plane.normal = Vec3(-1, 0, 2).normalized();
  CHECK(section_of(plane, {0, 0}, {10, 0}).height(10) == Approx(5));
  CHECK(section_error(slope_mesh(), {0, 5}, {25, 5}) ==
        "the terrain has no ground on the line of the section 20 m from its begin, at (20, 5)");
  CHECK(section_error(slope_mesh(), {-2, 5}, {15, 5}).find("has no ground on the line of the section 0 m") !=
        std::string::npos);
  Mesh overhang = slope_mesh();
  // A roof over the floor: down at the face, back out.
  overhang.vertices.insert(overhang.vertices.end(), {{0, 0, 6}, {0, 10, 6}, {14, 0, 5}, {14, 10, 5}});
  overhang.triangles.insert(overhang.triangles.end(), {{6, 8, 9}, {6, 9, 7}});
  overhang.part.insert(overhang.part.end(), {0, 0});
  CHECK(section_error(overhang, {1, 5}, {19, 5}).find("the terrain hangs over on the line of the section") ==
        0);
}

TEST_CASE("upright ground is a step of the section") {
  Mesh mesh;
  mesh.vertices = {{0, 0, 5},  {10, 0, 5},  {10, 10, 5}, {0, 10, 5},
                   {10, 0, 0}, {10, 10, 0}, {20, 0, 0},  {20, 10, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {4, 6, 7}, {4, 7, 5}};
  mesh.part = {0, 0, 1, 1, 2, 2};
  mesh.parts = {"top", "wall", "floor"};
  const Profile profile = section_of(mesh, {1, 5}, {19, 5});
  CHECK(profile.fault().empty());
  REQUIRE(profile.points.size() == 4);
  CHECK(profile.part == std::vector<int>{0, 1, 2});
  CHECK(profile.points[2] == Vec2(9, 0));
}
