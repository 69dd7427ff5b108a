#include "geometry/earthworks.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace earthworks_test {

/// A face of 10 m at x = 0, then a floor that rises by `rise` over 100 m.
Profile wall(double rise = 0) {
  return {.points = {{-20, 10}, {0, 10}, {0, 0}, {100, rise}}, .part = {0, 0, 0}, .parts = {""}, .faces = {}};
}

GroundDitch ditch_at(double x) { return {.x = x, .width = 3, .depth = 2, .slope = pi / 4}; }
GroundBund bund_of(std::optional<double> x, double distance = 0) {
  return {.x = x, .distance = distance, .height = 2, .top = 1, .slope = std::atan(0.5)};
}

std::string fault_of(const Profile& profile, const Earthworks& works) {
  try {
    with_earthworks(profile, works);
  } catch (const EarthworksError& error) {
    return error.what();
  }
  return {};
}

bool is_near(const std::vector<Vec2>& points, const std::vector<Vec2>& expected) {
  if (points.size() != expected.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i] - expected[i]).norm() > 1e-12) return false;
  return true;
}

}  // namespace earthworks_test
using namespace earthworks_test;

TEST_CASE("a ditch and the bund beyond it have their forms on level ground") {
  const Profile made = with_earthworks(wall(), {ditch_at(5), bund_of(std::nullopt, 1)});
  CHECK(is_near(made.points, {{-20, 10},
                              {0, 10},
                              {0, 0},
                              {5, 0},
                              {7, -2},
                              {10, -2},
                              {12, 0},
                              {13, 0},
                              {17, 2},
                              {18, 2},
                              {22, 0},
                              {100, 0}}));
  CHECK(made.parts == std::vector<std::string>{"", "ditch", "bund"});
  CHECK(made.part == std::vector<int>{0, 0, 0, 1, 1, 1, 0, 2, 2, 2, 0});
  CHECK(made.fault().empty());
}

TEST_CASE("a ditch at the toe of an upright face begins on the floor") {
  const Profile made = with_earthworks(wall(), {ditch_at(0), std::nullopt});
  CHECK(is_near(made.points, {{-20, 10}, {0, 10}, {0, 0}, {2, -2}, {5, -2}, {7, 0}, {100, 0}}));
}

TEST_CASE("sides go on to sloping ground, and upright ones are upright") {
  const Profile bund = with_earthworks(wall(10), {std::nullopt, bund_of(10)});
  // Far side: 3 - (x - 15) / 2 meets x / 10 at x = 17.5.
  CHECK(
      is_near(bund.points, {{-20, 10}, {0, 10}, {0, 0}, {10, 1}, {14, 3}, {15, 3}, {17.5, 1.75}, {100, 10}}));
  const Profile trench = with_earthworks(wall(), {GroundDitch{5, 3, 2, pi / 2}, std::nullopt});
  CHECK(trench.points[4].x() == 5);
  CHECK(trench.points[6].x() == trench.points[5].x());
  CHECK(trench.fault().empty());
}

TEST_CASE("points of the survey below a bund are replaced, and parts beside it stay") {
  const Profile rough = {.points = {{0, 0}, {11, 0.2}, {12, 0.1}, {14, 0.3}, {30, 0}, {40, 0}},
                         .part = {0, 1, 1, 0, 1},
                         .parts = {"floor", "road"},
                         .faces = {}};
  const Profile made = with_earthworks(rough, {std::nullopt, bund_of(10.0)});
  CHECK(made.points.size() == 7);
  CHECK(made.part == std::vector<int>{0, 2, 2, 2, 0, 1});
  CHECK(made.points[1].x() == 10);
}

TEST_CASE("earthworks that fit nowhere say where they do not") {
  CHECK(fault_of(wall(), {ditch_at(120), std::nullopt}) ==
        "the ditch begins at x = 120 m, the profile goes from -20 to 100 m");
  CHECK(fault_of(wall(), {ditch_at(97), std::nullopt}).starts_with("the ditch "));
  CHECK(fault_of(wall(), {std::nullopt, bund_of(95.0)}) ==
        "the bund does not come back to the ground before the profile ends at x = 100 m");
  CHECK(fault_of(wall(-100), {ditch_at(5), std::nullopt}).find("the ditch meets the ground at x = ") == 0);
  CHECK(fault_of(wall(100), {std::nullopt, bund_of(5.0)}).find("the bund meets the ground at x = ") == 0);
}
