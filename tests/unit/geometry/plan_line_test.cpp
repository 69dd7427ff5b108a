// When a path in plan arrives at a line, against closed forms.

#include "geometry/plan_line.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();

/// From `start` with a velocity and a constant acceleration.
PlanPath path(const Vec2& start, const Vec2& v, const Vec2& a = Vec2::Zero()) {
  return {.x = {start.x(), v.x(), 0.5 * a.x()}, .y = {start.y(), v.y(), 0.5 * a.y()}};
}

/// The time at which the path arrives; -1 if it does not.
double time_to(const PlanLine& line, const PlanPath& path, double end = no_end) {
  const auto arrival = Approach(line, path.position(0)).arrival(path, end);
  return arrival ? arrival->time : -1;
}

}  // namespace

TEST_CASE("a path arrives at a polyline where it crosses a piece, and not where it crosses its extension") {
  const PlanLine line({{10, -5}, {10, 5}, {20, 15}});
  CHECK(time_to(line, path({0, 0}, {2, 0})) == 5);
  CHECK(time_to(line, path({30, 1}, {-2, 0})) == 10);  // from the other side
  CHECK(time_to(line, path({0, 10}, {5, 0})) == Approx(3).epsilon(1e-14));
  CHECK(time_to(line, path({0, -6}, {2, 0})) == -1);  // past its end
  CHECK(time_to(line, path({0, 16}, {2, 0})) == -1);
  CHECK(time_to(line, path({0, 0}, {2, 0}), 4.9) == -1);
  const auto arrival = Approach(line, {0, 10}).arrival(path({0, 10}, {5, 0}), no_end);
  CHECK((arrival->place - Vec2(15, 10)).norm() < 1e-12);
  CHECK(arrival->along == Approx(10 + std::sqrt(50)).epsilon(1e-14));
}

TEST_CASE("a path through a corner, an end or along a piece of a line arrives") {
  const PlanLine line({{10, -5}, {10, 5}, {20, 15}});
  CHECK(time_to(line, path({0, 5}, {2, 0})) == Approx(5));      // through the corner
  CHECK(time_to(line, path({0, 15}, {2, 0})) == Approx(10));    // through its end
  CHECK(time_to(line, path({10, -25}, {0, 2})) == Approx(10));  // along the first piece, into its end
  CHECK(time_to(line, path({10, 0}, {0, 2})) == 0);             // starts on it
  for (int i = 0; i < 1000; ++i) {  // past the corner at every angle: no gap between the pieces
    const Vec2 start(3 + 0.001 * i, -7 + 0.013 * i);
    CHECK(time_to(line, path(start, Vec2(10, 5) - start)) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("a path that wind turns back arrives at the piece that it crosses on its way back") {
  // Across the extension of the line at t = 1, and back across the line at t = 3.
  const PlanLine line({{10, 0}, {10, 10}});
  const PlanPath turned = path({7, -5}, {4, 2.5}, {-2, 0});
  CHECK(time_to(line, turned) == Approx(3).epsilon(1e-14));
  PlanPath long_way = turned;  // the same as a polynomial of degree 5 that differs little
  long_way.x[5] = 1e-12;
  CHECK(time_to(line, long_way, 10) == Approx(3).epsilon(1e-9));
  CHECK(time_to(line, long_way, 2.9) == -1);
}

TEST_CASE("no crossing is lost to rounding between two stretches of a path") {
  const PlanLine line({{1, -1}, {1, 1}});
  Approach approach(line, {0, 0});
  approach.move_to({1 - 1e-16, 0});
  const auto arrival = approach.arrival(path({1 + 3e-16, 0}, {1, 0}), 1);  // it lies beyond by rounding
  REQUIRE(arrival);
  CHECK(arrival->time == 0);
  approach.arrive();
  CHECK_FALSE(approach.arrival(path({2, 0}, {-1, 0}), 5));  // once
}

TEST_CASE("a line across x has no ends, in 2D and 3D") {
  CHECK(time_to(PlanLine(5), path({0, 0}, {10, 0})) == 0.5);
  CHECK(time_to(PlanLine(5), path({0, 1e5}, {10, 1e4})) == 0.5);
  CHECK(time_to(PlanLine(5), path({5, 0}, {1, 0})) == 0);
  CHECK(time_to(PlanLine(5), path({0, 0}, {-1, 0})) == -1);
}

TEST_CASE("the points of a line that is none are refused with their place") {
  CHECK(line_fault({{1, 2}}) == "a line needs at least 2 points, this one has 1");
  CHECK(line_fault({{0, 0}, {0, 0}, {1, 0}}) == "a line has the point (0, 0) twice in a row");
  CHECK(line_fault({{0, 0}, {2, 0}, {1, 0}}) == "the line turns back on itself at (2, 0)");
  CHECK(line_fault({{0, 0}, {10, 0}, {10, 5}, {5, -5}}) ==
        "the line crosses itself: the piece from (0, 0) to (10, 0) meets the piece from (10, 5) to (5, -5)");
  CHECK(line_fault({{0, 0}, {10, 0}, {10, 5}, {5, 0}}).starts_with("the line crosses itself"));  // touches
  CHECK(line_fault({{0, 0}, {10, 0}, {10, 5}, {0, 0}}).empty());                                 // a ring
  CHECK(line_fault({{2600000, 1200000}, {2600010, 1200000}, {2600020, 1200005}}).empty());
}

TEST_CASE("a place lies on the side of the nearest piece of a line, which goes on beyond its ends") {
  const PlanLine corner({{0, -10}, {0, 0}, {10, 0}});
  CHECK(corner.side({-1, -5}) == 1);
  CHECK(corner.side({1, -5}) == -1);
  CHECK(corner.side({-3, 4}) == 1);  // nearest to the corner, from outside
  CHECK(corner.side({0.1, -0.2}) == -1);
  CHECK(corner.side({5, 1e6}) == 1);
  CHECK(corner.side({1e6, -1}) == -1);  // beyond its end
  CHECK(corner.side({-1, -1e6}) == 1);  // beyond its start
  const PlanLine sharp({{0, 0}, {10, 1}, {0, 2}});
  for (const double y : {-3.0, 0.5, 1.0, 1.5, 5.0}) CHECK(sharp.side({11, y}) == -1);  // beyond the tip
  CHECK(sharp.side({5, 1}) == 1);
  const PlanLine ring({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});
  for (const Vec2& outside :
       {Vec2(-1, -1), Vec2(11, -1), Vec2(11, 11), Vec2(-1, 11), Vec2(5, -3), Vec2(-3, 5)})
    CHECK(ring.side(outside) == -1);
  CHECK(ring.side({5, 5}) == 1);
  CHECK(ring.side({0.1, 0.1}) == 1);
  CHECK(PlanLine(5).side({4, 1e9}) == -PlanLine(5).side({6, -1e9}));
}
