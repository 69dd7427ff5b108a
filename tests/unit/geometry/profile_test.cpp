// The terrain of a 2D run: its height and what is no profile.

#include "geometry/profile.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

Profile line(std::vector<Vec2> points) {
  Profile profile;
  profile.points = std::move(points);
  profile.part.assign(profile.points.empty() ? 0 : profile.points.size() - 1, 0);
  profile.parts = {""};
  return profile;
}

}  // namespace

TEST_CASE("a profile knows its height, the highest where it is vertical") {
  const Profile step = line({{0, 4}, {2, 3}, {2, 1}, {6, 1}});
  CHECK(step.fault().empty());
  CHECK(step.height(0) == 4);
  CHECK(step.height(1) == Approx(3.5));
  CHECK(step.height(2) == 3);
  CHECK(step.height(5) == 1);
  CHECK(step.height(6) == 1);
  const Profile rise = line({{0, 0}, {2, 0}, {2, 5}, {6, 5}});
  CHECK(rise.height(2) == 5);
}

TEST_CASE("a profile says what is wrong with it") {
  CHECK(line({{0, 0}}).fault() == "a profile has 1 points, at least 2 are needed");
  CHECK(line({{0, 0}, {0, 0}, {1, 0}}).fault() == "a profile has the point (0, 0) twice in a row");
  CHECK(line({{0, 0}, {2, 1}, {1, 2}}).fault() ==
        "x decreases from (2, 1) to (1, 2); a profile goes from left to right: sort the points, or, if the "
        "wall overhangs there, "
        "run in `dimension: 3` with the section extruded as a `mesh`");
  CHECK(line({{0, 0}, {1, 0}, {1, 2}, {1, 1}, {2, 1}}).fault() == "a profile turns straight back at (1, 2)");
  CHECK(line({{1, 0}, {1, 2}}).fault() == "a profile has no width: all its points have x = 1");
  Profile parts = line({{0, 0}, {1, 0}});
  parts.part = {1};
  CHECK(parts.fault() == "a profile of 1 parts has a segment of part 1");
  parts.part = {0, 0};
  CHECK(parts.fault() == "the profile has 1 segments but 2 part numbers");
}
