// The outline of the blasting area, against closed forms.

#include "report/exports/area_outline.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace area_outline_test {

namespace {

double outline_size(const PlanRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
  return sum;
}

std::vector<AreaSector> equal_sectors(std::size_t count, double distance) {
  std::vector<AreaSector> sectors;
  for (std::size_t i = 0; i < count; ++i)
    sectors.push_back({2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count), distance});
  return sectors;
}

}  // namespace

TEST_CASE("the area about one place is a circle, and about a square it has round corners") {
  CHECK(outline_size(area_outline({5, 7}, {{5, 7}}, equal_sectors(24, 100))) ==
        Approx(pi * 1e4).epsilon(1e-3));
  const std::vector<Vec2> square = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
  CHECK(outline_size(area_outline({0, 0}, square, equal_sectors(24, 30))) ==
        Approx(400 + 80 * 30 + pi * 900).epsilon(1e-3));
  CHECK(outline_size(area_outline({0, 0}, square, equal_sectors(8, 0))) == Approx(400).epsilon(1e-3));
}

TEST_CASE("each sector of the area ends at its own distance") {
  std::vector<AreaSector> sectors = equal_sectors(4, 10);
  sectors[1].distance = 20;
  CHECK(outline_size(area_outline({0, 0}, {{0, 0}}, sectors)) ==
        Approx(pi / 4 * (3 * 100 + 400)).epsilon(1e-3));
}

}  // namespace area_outline_test
