// Pieces of the ground for pictures: the ground's own triangles, or a lattice of its heights.
#include "geometry/ground_surface.h"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "geometry/ground.h"

using namespace flyrock;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

HeightGrid grid(int columns, int rows, double cell) {
  HeightGrid shape;
  shape.columns = columns;
  shape.rows = rows;
  shape.cell = cell;
  shape.corner = {-3, 2};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) shape.heights.push_back(std::sin(0.3 * c) + 0.2 * r);
  return shape;
}

double area_in_plan(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2 start = mesh.vertices[a].head<2>();
    area += 0.5 * cross(Vec2(mesh.vertices[b].head<2>() - start), Vec2(mesh.vertices[c].head<2>() - start));
  }
  return area;
}

}  // namespace

TEST_CASE("A piece of a grid is cut at the border of its window and lies on the ground") {
  const auto ground = make_ground(grid(21, 21, 0.5));
  const Box2 window{{-1.3, 3.1}, {2.2, 4.9}};
  const GroundSurface piece = surface_within(*ground, window, 10'000);
  CHECK(piece.lattice == 0);
  CHECK(piece.mesh.part.size() == piece.mesh.triangles.size());
  CHECK(area_in_plan(piece.mesh) == Approx(3.5 * 1.8).epsilon(1e-12));
  for (const Vec3& v : piece.mesh.vertices) {
    CHECK((v.head<2>().array() >= window.low.array()).all());
    CHECK((v.head<2>().array() <= window.high.array()).all());
    CHECK(ground->height(v.x(), v.y()).value() == Approx(v.z()).margin(1e-12));
  }
}

TEST_CASE("Triangles that are cut at their common edge share its vertices") {
  const auto ground = make_ground(grid(21, 21, 0.5));
  const GroundSurface piece = surface_within(*ground, {{-1.3, 3.1}, {2.2, 4.9}}, 10'000);
  // Euler: a disk of triangles has V - E + F = 1.
  std::set<std::pair<int, int>> edges;
  for (const auto& triangle : piece.mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax({triangle[i], triangle[(i + 1) % 3]}));
  CHECK(static_cast<int>(piece.mesh.vertices.size()) - static_cast<int>(edges.size()) +
            static_cast<int>(piece.mesh.triangles.size()) ==
        1);
}

TEST_CASE("Where there are too many triangles every n-th height of a grid stands for them") {
  HeightGrid shape = grid(101, 101, 0.5);
  shape.part.assign(shape.heights.size(), 0);
  shape.parts = {"soil", "rock"};
  for (std::size_t i = 0; i < shape.part.size(); ++i) shape.part[i] = i % 101 >= 50;
  const HeightGrid copy = shape;
  const auto ground = make_ground(std::move(shape));
  const GroundSurface piece = surface_within(*ground, {{-100, -100}, {100, 100}}, 2000);
  CHECK(piece.lattice == 2);  // 1250 triangles; a lattice of 1.5 m has 2178
  CHECK(piece.mesh.triangles.size() == 1250);
  for (const Vec3& v : piece.mesh.vertices)
    CHECK(v.z() ==
          Approx(copy.at(std::lround((v.x() + 3) / 0.5), std::lround((v.y() - 2) / 0.5))).margin(1e-12));
  for (std::size_t t = 0; t < piece.mesh.triangles.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int v : piece.mesh.triangles[t]) middle += piece.mesh.vertices[v] / 3;
    CHECK(piece.mesh.part[t] == (middle.x() > -3 + 50 * 0.5));
  }
}

TEST_CASE("A plane is a rectangle over the window") {
  const auto ground = make_ground(Plane{{0, 0, 5}, Vec3(-0.6, 0, 0.8)});
  const GroundSurface piece = surface_within(*ground, {{10, -1}, {30, 4}}, 1000);
  CHECK(piece.mesh.triangles.size() == 2);
  CHECK(area_in_plan(piece.mesh) == Approx(100));
  for (const Vec3& v : piece.mesh.vertices) CHECK(v.z() == Approx(5 + 0.75 * v.x()));
}

TEST_CASE("Beyond the ground and in its holes there are no triangles") {
  HeightGrid shape = grid(11, 11, 1);
  shape.heights[60] = nothing;
  const auto ground = make_ground(std::move(shape));
  CHECK(surface_within(*ground, {{50, 50}, {60, 60}}, 1000).mesh.triangles.empty());
  CHECK(area_in_plan(surface_within(*ground, {{-50, -50}, {60, 60}}, 1000).mesh) == Approx(96));
}

TEST_CASE("The ground under a line is split where there is none") {
  HeightGrid shape = grid(11, 3, 1);
  shape.heights[5] = nothing;  // no ground from x = 1 to x = 3 beside y = 2
  const auto ground = make_ground(std::move(shape));
  const auto lines = heights_along(*ground, {-5, 2.5}, {9, 2.5}, 141);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].front().x() == Approx(2));
  CHECK(lines[0].back().x() == Approx(6).margin(0.2));
  CHECK(lines[1].front().x() == Approx(8).margin(0.2));
  CHECK(lines[1].back().x() == Approx(12));
  for (const auto& line : lines)
    for (const Vec2& place : line) CHECK(place.y() == Approx(ground->height(place.x() - 5, 2.5).value()));
}

TEST_CASE("The cell of a grid and the median edge of a mesh are known") {
  CHECK(make_ground(grid(5, 5, 0.25))->cell() == 0.25);
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.part = {0, 0};
  mesh.parts = {""};
  CHECK(make_ground(std::move(mesh))->cell() == 4);
  CHECK(make_ground(Plane{})->cell() == 0);
}
