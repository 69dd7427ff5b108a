// A body that moves a little within a step: most segments are passed over without a search.

#include <catch2/catch.hpp>
#include <random>

#include "collision/ground/terrain_2d.h"
#include "collision/pairs.h"
#include "scratch.h"

using namespace flyrock;

namespace {

Terrain2 rough(std::mt19937& rng) {
  std::uniform_real_distribution<double> height(-0.15, 0.15);
  Profile profile;
  for (int i = 0; i <= 20; ++i) profile.points.push_back({i - 10.0, height(rng)});
  profile.part.assign(20, 0);
  profile.parts = {""};
  return Terrain2(profile);
}

}  // namespace

TEST_CASE("a slow polygon, wall or rounded polygon finds the touch that a search over a longer time finds") {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Contactor2 shapes[] = {
      Contactor2::polygon({{-0.5, -0.3}, {0.4, -0.4}, {0.6, 0.1}, {0.1, 0.5}, {-0.4, 0.3}}),
      Contactor2::polygon({{-0.5, -0.1}, {0.5, -0.1}, {0.5, 0.1}, {-0.5, 0.1}}),
      Contactor2::wall({-0.4, 0}, {0.4, 0}, 0.1),
      Contactor2::hull({{-0.3, -0.2}, {0.3, -0.3}, {0.4, 0.1}, {-0.2, 0.3}}, 0.1)};
  int touches = 0, passes = 0;
  for (int k = 0; k < 4000; ++k) {
    const Terrain2 ground = rough(rng);
    const Contactor2& shape = shapes[k % 4];
    Motion2 motion;
    motion.x = {8 * unit(rng), 1.5};
    motion.angle = 3 * unit(rng);
    motion.v = {0.5 * unit(rng), 0.5 * unit(rng)};
    motion.a = {0, -9.81};
    motion.w = unit(rng);
    // Lowered until it is 0 to 1 cm above the ground
    TouchSearch search;
    search.size = shape.bound;
    Motion2 fall;
    fall.x = motion.x;
    fall.angle = motion.angle;
    fall.v = {0, -1};
    const auto down = time_of_contact<2>(scratch(), {shape, fall}, ground, 5, search);
    REQUIRE(down);
    motion.x.y() -= *down - 0.005 * (1 + unit(rng)) - 1e-6;
    const double step = 0.02;
    const auto slow = time_of_contact<2>(scratch(), {shape, motion}, ground, step, search);
    const auto longer = time_of_contact<2>(scratch(), {shape, motion}, ground, 40 * step, search);
    INFO("case " << k);
    REQUIRE(slow.has_value() == (longer && *longer <= step));
    if (slow) REQUIRE(*slow == Approx(*longer).margin(1e-9));
    (slow ? touches : passes)++;
  }
  CHECK(touches > 500);
  CHECK(passes > 500);
}

TEST_CASE("a vertex on the end of an edge, or deep below its line, is not taken for a touch at once") {
  // A square whose corner passes close beside a convex corner of the ground
  Profile profile;
  profile.points = {{-10, 0}, {0, 0}, {1, -3}, {10, -3}};
  profile.part = {0, 0, 0};
  profile.parts = {""};
  const Terrain2 ground(profile);
  const Contactor2 square = Contactor2::polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  Motion2 motion;
  motion.x = {0.5 + 1e-6, 0.6};
  motion.v = {0, -2};
  TouchSearch search;
  search.size = square.bound;
  // Its left side falls past the corner at x = 0 and meets the face below it with its lower left corner.
  const auto touch = time_of_contact<2>(scratch(), {square, motion}, ground, 10, search);
  REQUIRE(touch);
  CHECK(*touch == Approx((0.6 - 0.5 + 3e-6) / 2).epsilon(1e-6));
}
