#include <catch2/catch.hpp>

#include "collision/ground/terrain_2d.h"
#include "collision/pairs.h"
#include "math/space.h"
#include "scratch.h"

using namespace flyrock;

namespace time_of_contact_test {

namespace {

Terrain2 level(double half_length = 100) {
  Profile profile;
  profile.points = {{-half_length, 0}, {half_length, 0}};
  profile.part = {0};
  profile.parts = {""};
  return Terrain2(profile);
}

const Contactor2 square = Contactor2::polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});

Motion2 thrown(const Vec2& x, const Vec2& v, double w = 0, double angle = 0) {
  Motion2 motion;
  motion.x = x;
  motion.v = v;
  motion.a = {0, -9.81};
  motion.w = w;
  motion.angle = angle;
  return motion;
}

/// Lowest vertex of the turned square.
double lowest(const Motion2& motion, double t) {
  const Rotation2 r = Rotation2::from_angle(motion.angle_at(t));
  double low = 1e300;
  for (const Vec2& p : square.points) low = std::min(low, (motion.position(t) + r * p).y());
  return low;
}

}  // namespace

TEST_CASE("a pair released at gap 0 returns if it has a speed away, else it touches at once or never") {
  const Terrain2 ground = level();
  const HeldContact held[] = {{vertex_id(0, 0), segment_id(0)}};
  TouchSearch search;
  search.held.list = held;
  const Contactor2 disk = Contactor2::disk(0.5);
  CHECK(time_of_contact<2>(scratch(), {disk, thrown({0, 0.5}, {1, 3})}, ground, 10, search).value() ==
        Approx(6 / 9.81).epsilon(1e-15));
  CHECK(time_of_contact<2>(scratch(), {disk, thrown({0, 0.5}, {1, 0})}, ground, 10, search).value() == 0);
  Motion2 weightless = thrown({0, 0.5}, {1, 0});
  weightless.a.setZero();
  CHECK_FALSE(time_of_contact<2>(scratch(), {disk, weightless}, ground, 10, search));

  TouchSearch loose;
  CHECK(time_of_contact<2>(scratch(), {square, thrown({0, 0.5}, {1, 3})}, ground, 10, loose).value() ==
        Approx(6 / 9.81).epsilon(1e-11));
}

TEST_CASE("the gap at the time of contact is at most 1e-12 of the size, and not negative") {
  const Terrain2 ground = level();
  TouchSearch search;
  search.size = square.bound;
  std::uint64_t iterations = 0;
  search.iterations = &iterations;
  const double w = GENERATE(0.0, 0.7, -3.0, 40.0, 500.0);
  for (int k = 0; k < 50; ++k) {
    const Motion2 motion = thrown({0, 3 + 0.1 * k}, {0.3 * k, 2.0 - 0.2 * k}, w, 0.1 * k);
    iterations = 0;
    const auto t = time_of_contact<2>(scratch(), {square, motion}, ground, 10, search);
    REQUIRE(t);
    CHECK(lowest(motion, *t) <= 2e-12);
    CHECK(lowest(motion, *t) >= -1e-13);
    // Nothing touched before.
    for (int i = 1; i < 2000; ++i) REQUIRE(lowest(motion, *t * i / 2000.0) > 0);
    CHECK(iterations < 400);
  }
}

TEST_CASE("a grazing approach of 1e-6 rad is found") {
  const Terrain2 ground = level(1e4);
  const double angle = 1e-6;
  Motion2 motion;
  motion.v = {std::cos(angle), -std::sin(angle)};
  motion.x = {-10, 0.5 + 5e-6};
  TouchSearch search;
  CHECK(time_of_contact<2>(scratch(), {Contactor2::disk(0.5), motion}, ground, 100, search).value() ==
        Approx(5e-6 / std::sin(angle)).epsilon(1e-9));
  CHECK(time_of_contact<2>(scratch(), {square, motion}, ground, 100, search).value() ==
        Approx(5e-6 / std::sin(angle)).epsilon(1e-6));
}

TEST_CASE("a disk meets a corner on the exact root of the quartic") {
  Profile profile;
  profile.points = {{-10, -10}, {0, 0}, {10, -10}};
  profile.part = {0, 0};
  profile.parts = {""};
  const Terrain2 ridge{profile};
  const double radius = 0.25;
  const Motion2 motion = thrown({-1, 1.5}, {1.95, 0});
  const double t =
      time_of_contact<2>(scratch(), {Contactor2::disk(radius), motion}, ridge, 10, TouchSearch{}).value();
  CHECK(motion.position(t).norm() == Approx(radius).epsilon(1e-14));
  CHECK(motion.position(t).norm() >= radius * (1 - 1e-15));
}

TEST_CASE("a disk of 1 cm at 300 m/s does not pass a wall of 1 mm") {
  const Contactor2 wall = Contactor2::polygon({{-5e-4, -1}, {5e-4, -1}, {5e-4, 1}, {-5e-4, 1}});
  const Contactor2 pebble = Contactor2::disk(0.005);
  Motion2 shot, still;
  shot.v = {300, 0};
  for (int k = 0; k < 100; ++k) {
    shot.x = {-0.1 - 0.01 * k, 0};
    TouchSearch search;
    search.size = 0.005;
    const auto t = time_of_contact<2>(scratch(), {pebble, shot}, {wall, still}, 1, search);
    REQUIRE(t);
    CHECK(shot.position(*t).x() == Approx(-0.0055).margin(1e-13));
  }
}

}  // namespace time_of_contact_test
