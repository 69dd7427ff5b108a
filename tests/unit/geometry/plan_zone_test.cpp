// Zones in plan: what lies inside of an outline, and how triangles are cut along it.

#include "geometry/plan_zone.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/mesh_fault.h"

using namespace flyrock;

namespace {

using Polygon = std::vector<Vec2>;

/// Two triangles over a square of 10 m, inclined.
Mesh slope() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 2}, {10, 10, 3}, {0, 10, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.part = {0, 0};
  mesh.parts = {"rock"};
  return mesh;
}

/// The area in plan of a part.
double area_of(const Mesh& mesh, int part) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.part[t] != part) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    area += cross(Vec2((mesh.vertices[b] - mesh.vertices[a]).head<2>()),
                  Vec2((mesh.vertices[c] - mesh.vertices[a]).head<2>())) /
            2;
  }
  return area;
}

}  // namespace

TEST_CASE("a place lies inside of a polygon that bends inwards") {
  const Polygon bent{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  CHECK(is_inside(bent, {1, 1}));
  CHECK(is_inside(bent, {3, 2}));
  CHECK_FALSE(is_inside(bent, {2, 2}));
  CHECK_FALSE(is_inside(bent, {5, 1}));
}

TEST_CASE("polygons that overlap are one region, and only their inner rings are holes") {
  const auto square = [](double low, double high) {
    return std::vector<Vec2>{{low, low}, {high, low}, {high, high}, {low, high}};
  };
  const std::vector<PlanPolygon> twice = {{square(0, 4), {}}, {square(0, 4), {}}, {square(2, 6), {}}};
  CHECK(is_inside(twice, {1, 1}));
  CHECK(is_inside(twice, {3, 3}));
  CHECK(is_inside(twice, {5, 5}));
  CHECK_FALSE(is_inside(twice, {5, 1}));
  const std::vector<PlanPolygon> holed = {{square(0, 6), {square(1, 3), square(2, 4)}}, {square(2, 3), {}}};
  CHECK(is_inside(holed, {0.5, 0.5}));
  CHECK_FALSE(is_inside(holed, {1.5, 1.5}));
  CHECK(is_inside(holed, {2.5, 2.5}));  // of the second polygon
  CHECK_FALSE(is_inside(holed, {3.5, 3.5}));
}

TEST_CASE("an outline that is no simple polygon says why") {
  CHECK(polygon_fault({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}).empty());
  CHECK(polygon_fault({{0, 0}, {4, 0}}) == "a polygon has 2 corners, at least 3 are needed");
  CHECK(polygon_fault({{0, 0}, {4, 4}, {4, 0}, {0, 4}}) ==
        "the outline of a polygon crosses itself between (0, 0) and (4, 0)");
  CHECK(polygon_fault({{0, 0}, {0, 0}, {4, 4}}).find("twice in a row") != std::string::npos);
}

TEST_CASE("triangles are cut exactly along a zone and keep their surface") {
  const std::vector<Polygon> zones{
      {{2, 1}, {5, 1}, {5, 8}, {2, 8}},                   // inside
      {{-3, 4}, {13, 4}, {13, 6}, {-3, 6}},               // a road across
      {{0, 0}, {10, 0}, {10, 10}},                        // along the edges that are there
      {{1, 1}, {9, 1.5}, {5, 4}, {8, 9}, {2, 8}, {3, 3}}  // bent
  };
  const std::vector<double> areas{21, 20, 50, 0};
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Mesh mesh = std::get<Mesh>(with_zone(slope(), "zone", zones[i]));
    CHECK(fault(mesh) == "");
    double expected = areas[i];
    if (expected == 0)
      for (std::size_t k = 0; k < zones[i].size(); ++k)
        expected += cross(zones[i][k], zones[i][(k + 1) % zones[i].size()]) / 2;
    CHECK(area_of(mesh, 1) == Approx(expected));
    CHECK(area_of(mesh, 0) + area_of(mesh, 1) == Approx(100));
    for (const Vec3& vertex : mesh.vertices)  // both triangles lie in planes
      CHECK(vertex.z() == Approx(vertex.x() > vertex.y() ? 0.2 * vertex.x() + 0.1 * vertex.y()
                                                         : 0.2 * vertex.x() + 0.1 * vertex.y()));
    CHECK(mesh.parts == std::vector<std::string>{"rock", "zone"});
  }
}

TEST_CASE("random zones on random ground leave a ground without gaps") {
  std::uint32_t state = 1;
  const auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return state / 4294967296.0;
  };
  for (int trial = 0; trial < 200; ++trial) {
    Mesh mesh;
    constexpr int n = 5;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        mesh.vertices.emplace_back(i + 0.3 * random(), j + 0.3 * random(), random());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i;
        mesh.triangles.push_back({a, a + 1, a + n + 2});
        mesh.triangles.push_back({a, a + n + 2, a + n + 1});
      }
    mesh.part.assign(mesh.triangles.size(), 0);
    mesh.parts = {""};
    const double whole = area_of(mesh, 0);
    Polygon zone;
    for (int k = 0; k < 7; ++k) {
      const double angle = 2 * pi * (k + 0.8 * random()) / 7, radius = 0.3 + 1.8 * random();
      zone.emplace_back(2.5 + radius * std::cos(angle), 2.5 + radius * std::sin(angle));
    }
    double expected = 0;
    for (std::size_t k = 0; k < zone.size(); ++k) expected += cross(zone[k], zone[(k + 1) % zone.size()]) / 2;
    const Mesh cut = std::get<Mesh>(with_zone(mesh, "zone", zone));
    CHECK(fault(cut) == "");
    CHECK(area_of(cut, 1) == Approx(expected).margin(0.02));
    CHECK(area_of(cut, 0) + area_of(cut, 1) == Approx(whole));
  }
}

TEST_CASE("a plane with a zone becomes a square, cells of a grid belong to the zone of their centre") {
  Plane plane;
  plane.point = {5, 0, 3};
  const Mesh square = std::get<Mesh>(with_zone(plane, "road", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  CHECK(area_of(square, 1) == Approx(100));
  CHECK(area_of(square, 0) == Approx(4e6 - 100));
  HeightGrid grid;
  grid.columns = grid.rows = 3;
  grid.heights.assign(9, 1.0);
  const auto zoned =
      std::get<HeightGrid>(with_zone(grid, "road", {{0.5, -1}, {3, -1}, {3, 0.5}, {0.5, 0.5}}));
  CHECK(zoned.part == std::vector<std::uint8_t>{0, 1, 1, 0, 0, 0, 0, 0, 0});
}
