// The cells of a ground beside the diameters of the rocks on it.
#include "results/say/cell_size.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

PointResult point_on(TerrainShape3 shape, double p50) {
  PointResult point;
  point.terrain.ground = std::make_shared<const Terrain3>(std::move(shape));
  point.diameters = {0.8 * p50, p50};
  return point;
}

HeightGrid ground_of_cells(double cell) {
  HeightGrid shape;
  shape.columns = shape.rows = 3;
  shape.cell = cell;
  shape.heights.assign(9, 1);
  return shape;
}

}  // namespace

TEST_CASE("Cells of one to five diameters are not warned of") {
  for (const double cell : {0.5, 1.0, 2.5}) {
    const PointResult point = point_on(ground_of_cells(cell), 0.5);
    CHECK(cell_size(point)->cell == cell);
    CHECK(cell_size(point)->p5 == Approx(0.4));
    CHECK(cell_warnings({point}).empty());
  }
}

TEST_CASE("A run warns of cells that hide bumps of the rocks' size, and of those that only cost time") {
  const auto coarse = cell_warnings({point_on(ground_of_cells(5), 0.5), point_on(ground_of_cells(5), 0.5)});
  REQUIRE(coarse.size() == 1);
  CHECK(coarse[0].find("are 5 m, 10 times the median diameter of the rocks (0.5 m). Bumps") !=
        std::string::npos);
  const auto fine = cell_warnings({point_on(ground_of_cells(0.05), 0.5)});
  REQUIRE(fine.size() == 1);
  CHECK(fine[0].find("are 0.05 m, 0.1 of the median diameter of the rocks (0.5 m). They cost time") !=
        std::string::npos);
}

TEST_CASE("A plane and benches have no cells to warn of") {
  CHECK_FALSE(cell_size(point_on(Plane{}, 0.5)));
  Mesh benches;
  benches.vertices = {{0, 0, 0}, {300, 0, 0}, {300, 400, 0}};
  benches.triangles = {{0, 1, 2}};
  benches.part = {0};
  benches.parts = {"face"};
  CHECK(cell_size(point_on(benches, 0.5))->cell == 400);
  benches.faces = {{"bench_1", {{0, 0, 0}}, {{0, 0, 10}}}};
  CHECK_FALSE(cell_size(point_on(benches, 0.5)));
  CHECK_FALSE(cell_size(PointResult()));
}
