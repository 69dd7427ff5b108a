// Which lines a rock that left the domain can no longer arrive at.

#include "flight/decided.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "../../dice.h"
#include "geometry/ground.h"
#include "world/places.h"

using namespace flyrock;

namespace decided_test {

/// Heights on a grid of cells of 10 m.
std::shared_ptr<const Terrain3> hills(int columns, int rows, Dice& dice) {
  HeightGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.cell = 10;
  for (int i = 0; i < columns * rows; ++i) grid.heights.push_back(dice(0, 5));
  return std::make_shared<const Terrain3>(TerrainShape3(grid));
}

}  // namespace decided_test

TEST_CASE("The least height of the ground along a line is that of its lowest place") {
  Dice dice;
  for (int i = 0; i < 20; ++i) {
    const auto terrain = decided_test::hills(6, 5, dice);
    const std::vector<Vec2> points{
        {dice(0, 50), dice(0, 40)}, {dice(0, 50), dice(0, 40)}, {dice(0, 50), dice(0, 40)}};
    double sampled = 1e9;
    for (std::size_t piece = 0; piece < 2; ++piece)
      for (int k = 0; k <= 4000; ++k) {
        const Vec2 at = points[piece] + k / 4000.0 * (points[piece + 1] - points[piece]);
        if (const auto height = terrain->ground().height(at.x(), at.y()))
          sampled = std::min(sampled, *height);
      }
    const auto least = least_height(PlanLine(points), *terrain);
    REQUIRE(least);
    CHECK(*least <= sampled + 1e-9);
    CHECK(*least > sampled - 0.05);
  }
  const auto terrain = decided_test::hills(3, 3, dice);
  CHECK(least_height(PlanLine(10.0), *terrain));  // across x, as far as there is ground
  CHECK_FALSE(least_height(PlanLine({{100, 0}, {100, 20}}), *terrain));  // no ground below it
  CHECK_FALSE(least_height(PlanLine(10.0), Terrain3(Plane{})));          // without ends
}

TEST_CASE("A rock that left the domain is decided beyond a line, and on this side if it lies too low") {
  Profile profile;
  profile.points = {{-50, 20}, {0, 10}, {50, 0}, {100, 0}};
  profile.part = {0, 0, 0};
  profile.parts = {""};
  const auto terrain = std::make_shared<const Terrain2>(profile);
  const std::vector<Gate> gates{{PlanLine(20.0)}, {PlanLine(-40.0)}};  // at the heights 6 m and 18 m
  DecidedLines<2> lines;
  const auto decided = [&](double start, double end, double lift) {
    return lines.of(gates, terrain, Departure{{start, 0}, {end, 0}, lift});
  };
  CHECK(decided(0, 100, 100) == 0b01);   // past the first gate; fast enough to come back to the other
  CHECK(decided(0, 100, 17.9) == 0b11);  // too slow for that
  CHECK(decided(30, 100, 5.9) == 0b11);
  CHECK(decided(30, 100, 6.1) == 0b10);
  CHECK(decided(-45, -50, 20) == 0b00);                                    // backwards, high above both
  CHECK(decided(-45, -50, std::numeric_limits<double>::infinity()) == 0);  // without gravity
}
