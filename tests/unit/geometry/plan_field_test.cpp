// Fields on a grid in plan, against closed forms.

#include "geometry/plan_field.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

TEST_CASE("the region of one kernel above a level is its disc") {
  // 1 - s^2/R^2 >= 0.75 within R/2.
  PlanField field(Vec2(-10, -10), Vec2(10, 10), 0.25);
  field.add_kernel(Vec2(0.1, -0.3), 10, 1);
  CHECK(field.at(Vec2(0.1, -0.3)) == Approx(1).margin(1e-3));
  CHECK(field.at(Vec2(5.1, -0.3)) == Approx(0.75).margin(1e-3));
  const auto rings = field.region_above(0.75);
  REQUIRE(rings.size() == 1);
  CHECK(area_of(rings) == Approx(pi * 25).epsilon(1e-3));  // counter-clockwise
  for (const Vec2& place : rings.front()) CHECK((place - Vec2(0.1, -0.3)).norm() == Approx(5).epsilon(2e-3));
}

TEST_CASE("a ring is filled, and two discs are two parts") {
  PlanField ring(Vec2(-40, -40), Vec2(40, 40), 0.5);
  for (int i = 0; i < 360; ++i)
    ring.add_kernel(20 * Vec2(std::cos(i * pi / 180), std::sin(i * pi / 180)), 5, 1);
  const auto filled = ring.region_above(1e-3);
  REQUIRE(filled.size() == 1);
  CHECK(area_of(filled) == Approx(pi * 25 * 25).epsilon(0.02));  // half a cell at the rim
  PlanField two(Vec2(-40, -40), Vec2(40, 40), 0.5);
  for (const double x : {-20.0, 20.0}) two.add_kernel(Vec2(x, 3), 8, 2);
  CHECK(two.region_above(1).size() == 2);
  CHECK(two.region_above(2.1).empty());
}

TEST_CASE("where there is no density the field is minus the distance from where it is") {
  PlanField field(Vec2(0, 0), Vec2(10, 10), 0.25);
  field.add_kernel(Vec2(5, 5), 2, 1);
  const PlanField with = field.with_distances(20);
  CHECK(with.at(Vec2(5, 5)) == Approx(1));
  for (const Vec2& place : {Vec2(15, 5), Vec2(5, -8), Vec2(12, 13)})
    CHECK(with.at(place) == Approx(2 - (place - Vec2(5, 5)).norm()).margin(0.3));
  CHECK(area_of(with.region_above(-4)) == Approx(pi * 36).epsilon(0.05));
}

TEST_CASE("a hull that is lifted lies in every region") {
  PlanField field(Vec2(-20, -20), Vec2(20, 20), 0.5);
  field.add_kernel(Vec2(12, 0), 4, 1);
  field.lift({Vec2(-10, -3.3), Vec2(-10, 4.1)});
  const auto rings = field.region_above(0.5);
  REQUIRE(rings.size() == 2);
  double low = 1e9, high = -1e9;
  for (const PlanRing& ring : rings)
    for (const Vec2& place : ring)
      if (place.x() < 0) {
        low = std::min(low, place.y());
        high = std::max(high, place.y());
      }
  CHECK(low < -3.3);
  CHECK(high > 4.1);
}
