#include "geometry/plan_hull.h"

#include <catch2/catch.hpp>
#include <random>

using namespace flyrock;

TEST_CASE("the hull in plan has the corners alone, whatever the order of the points") {
  std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 2}, {0, 2}, {2, 0}, {1, 1}, {4, 1}, {0, 0}};
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(points.begin(), points.end(), random);
    const std::vector<Vec2> hull = plan_hull(points);
    REQUIRE(hull.size() == 4);
    CHECK(hull[0] == Vec2(0, 0));
    CHECK(hull[1] == Vec2(4, 0));  // counter-clockwise
    CHECK(centroid_of(hull).isApprox(Vec2(2, 1)));
  }
}

TEST_CASE("a hull of one place or of a line is what it is, and its centroid is in the middle") {
  CHECK(plan_hull({}).empty());
  CHECK(plan_hull({{3, 4}, {3, 4}}).size() == 1);
  CHECK(centroid_of({{3, 4}}) == Vec2(3, 4));
  const std::vector<Vec2> line = plan_hull({{0, 0}, {3, 4}, {1.5, 2}, {6, 8}});
  CHECK(line.size() == 2);
  CHECK(centroid_of(line) == Vec2(3, 4));
  // Rounding off the line makes corners, and moves no centroid.
  std::vector<Vec2> rough;
  for (int i = 0; i <= 100; ++i) rough.push_back({0.1 * i, 0.3 * i / 7});
  CHECK((centroid_of(plan_hull(rough)) - Vec2(5, 0.5 * 30.0 / 7)).norm() < 1e-9);
}

TEST_CASE("the distance from a hull is 0 within it, else that from its nearest side or corner") {
  const std::vector<Vec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(distance_from(square, {1, 1}) == 0);
  CHECK(distance_from(square, {2, 1}) == 0);
  CHECK(distance_from(square, {1, 5}) == Approx(3));
  CHECK(distance_from(square, {5, 6}) == Approx(5));
  CHECK(distance_from({{1, 1}}, {4, 5}) == Approx(5));
  CHECK(distance_from({{0, 0}, {2, 0}}, {1, 3}) == Approx(3));
}
