// Regions in plan: outlines with holes around cells and triangles.

#include "geometry/plan_region.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "geometry/plan_zone.h"

using namespace flyrock;

namespace plan_region_test {

namespace {

double ring_area(const PlanRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += cross(Vec2(ring[i] - ring[0]), Vec2(ring[(i + 1) % ring.size()] - ring[0])) / 2;
  return sum;
}

/// Of outlines counter-clockwise and holes clockwise.
double region_area(const std::vector<PlanPolygon>& region) {
  double area = 0;
  for (const PlanPolygon& polygon : region) {
    area += ring_area(polygon.outline);
    for (const PlanRing& hole : polygon.holes) area += ring_area(hole);
  }
  return area;
}

bool covers(const std::vector<PlanPolygon>& region, const Vec2& place) {
  return std::any_of(region.begin(), region.end(), [&](const PlanPolygon& polygon) {
    return is_inside(polygon.outline, place) &&
           std::none_of(polygon.holes.begin(), polygon.holes.end(),
                        [&](const PlanRing& hole) { return is_inside(hole, place); });
  });
}

}  // namespace

TEST_CASE("the region around cells of a grid covers these cells and no other") {
  std::mt19937 random(7);
  for (int sample = 0; sample < 60; ++sample) {
    HeightGrid grid;
    grid.columns = 1 + static_cast<int>(random() % 12);
    grid.rows = 1 + static_cast<int>(random() % 12);
    grid.cell = 0.7;
    grid.corner = {2600000.25, 1200000};
    const unsigned share = 1 + random() % 9;  // tenths: few islands, or few holes
    std::size_t covered = 0;
    for (int i = 0; i < grid.columns * grid.rows; ++i) {
      grid.heights.push_back(random() % 10 < share ? 3 : random() % 5 == 0 ? std::nan("") : 1);
      covered += grid.heights.back() == 3;
    }
    const auto region = polygons_of(rings_around_cells(grid, [](double value) { return value == 3; }));
    CHECK(region_area(region) == Approx(0.49 * static_cast<double>(covered)).margin(1e-6));
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        CHECK(covers(region, grid.corner + grid.cell * Vec2(column, row)) == (grid.at(column, row) == 3));
    for (const PlanPolygon& polygon : region) {
      CHECK(polygon_fault(polygon.outline).empty());  // no ring touches itself
      CHECK(ring_area(polygon.outline) > 0);
      for (const PlanRing& hole : polygon.holes) CHECK(ring_area(hole) < 0);
    }
  }
}

TEST_CASE("rings in rings are outlines and holes in turn, whichever way they run") {
  const auto square = [](double half, bool turned) {
    PlanRing ring = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    if (turned) std::reverse(ring.begin(), ring.end());
    return ring;
  };
  const auto region = polygons_of({square(1, true), square(4, false), square(2, false), square(3, true)});
  REQUIRE(region.size() == 2);
  CHECK(region_area(region) == Approx(64 - 36 + 16 - 4));
  CHECK(region[0].holes.size() == 1);
  CHECK(region[1].holes.size() == 1);
}

TEST_CASE("the region of a part of a mesh is that of its triangles in plan") {
  Mesh mesh;  // a square of four triangles about its middle, and an upright wall on one side
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 1}, {1, 1, 3}, {2, 0, 5}, {2, 2, 5}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 5, 2}, {5, 6, 2}};
  mesh.part = {0, 0, 1, 0, 0, 0};
  mesh.parts = {"top", "north"};
  CHECK(region_area(polygons_of(rings_around_part(mesh, 0))) == Approx(3));
  const auto north = polygons_of(rings_around_part(mesh, 1));
  REQUIRE(north.size() == 1);
  CHECK(north[0].outline.size() == 3);
  CHECK(region_area(north) == Approx(1));
}

}  // namespace plan_region_test
