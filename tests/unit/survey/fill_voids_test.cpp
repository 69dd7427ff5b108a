// What fills the voids of a grid.

#include "survey/fill_voids.h"

#include <catch2/catch.hpp>
#include <limits>

#include "random/stream.h"

using namespace flyrock;

namespace fill_voids_test {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

HeightGrid slope(int columns, int rows) {
  HeightGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) grid.heights.push_back(100 + 0.5 * i - 0.25 * j);
  return grid;
}

double& at(HeightGrid& grid, int column, int row) {
  return grid.heights[static_cast<std::size_t>(row * grid.columns + column)];
}

}  // namespace

TEST_CASE("a membrane over a void in a plane is the plane") {
  for (int seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "voids", {});
    const HeightGrid made = slope(30, 25);
    HeightGrid grid = made;
    const auto size = static_cast<int>(rng.integer(1, 12));
    const auto column = static_cast<int>(rng.integer(1, 28 - size)),
               row = static_cast<int>(rng.integer(1, 23 - size));
    int cells = 0;
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        if (i == j || rng.uniform() < 0.8) {  // touching at corners is enough
          at(grid, column + i, row + j) = nothing;
          ++cells;
        }
    HeightGrid left = grid;
    if (size > 1) CHECK(fill_voids(left, size - 1).cells < cells);
    const FilledVoids filled = fill_voids(grid, size);
    CHECK(filled.cells == cells);
    for (std::size_t k = 0; k < made.heights.size(); ++k)
      REQUIRE(std::abs(grid.heights[k] - made.heights[k]) < 1e-4);
  }
}

TEST_CASE("a void at the outline of the grid stays") {
  HeightGrid grid = slope(6, 6);
  at(grid, 0, 0) = at(grid, 1, 1) = nothing;  // one void, by its corner
  at(grid, 3, 3) = nothing;
  const FilledVoids filled = fill_voids(grid, 3);
  CHECK((filled.count == 1 && filled.cells == 1));
  CHECK((std::isnan(at(grid, 0, 0)) && std::isnan(at(grid, 1, 1))));
  CHECK(at(grid, 3, 3) == Approx(100 + 1.5 - 0.75));
}

}  // namespace fill_voids_test
