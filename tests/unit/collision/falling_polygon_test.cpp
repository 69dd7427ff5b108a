// A polygon that falls on the ground touches it, however large the gap behind the other face of a segment.

#include <catch2/catch.hpp>

#include "collision/ground/terrain_2d.h"
#include "collision/pairs.h"
#include "scratch.h"

using namespace flyrock;

TEST_CASE("a falling square meets the segments of a bench") {
  Profile profile;
  profile.points = {{-50, 36}, {0, 36}, {4.367, 24}, {12.367, 24}};
  profile.part = {0, 0, 0};
  profile.parts = {""};
  const Terrain2 terrain(profile);
  const auto square = Contactor2::polygon({{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}});
  Motion2 motion;
  motion.x = {6, 25.2};
  motion.a = {0, -9.81};
  TouchSearch search;
  search.size = square.bound;
  for (double horizon : {0.5, 1.0, 60.0}) {
    const auto touch = time_of_contact<2>(scratch(), {square, motion}, terrain, horizon, search);
    REQUIRE(touch);
    CHECK(*touch == Approx(std::sqrt(2 / 9.81)).epsilon(1e-9));
  }
  CHECK_FALSE(time_of_contact<2>(scratch(), {square, motion}, terrain, 0.4, search));
}
