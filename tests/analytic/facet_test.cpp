// Internal edges are not felt: a plane of 1000 segments is a plane.
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a square slides over 1000 segments as over one") {
  const double slope = GENERATE(0.0, 0.2);
  Material material(0.5, 0.3);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  Bench bench(ground(50, slope, 1000), material, settings);
  const Vec2 up(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  bench.add(box(1, 1, 1000, -30 * along + 0.5 * up, -slope));
  bench.world.bodies[0].v = 10 * along;
  const BodyHistory& history = bench.run(2);
  const double a = 9.81 * (std::sin(slope) - 0.3 * std::cos(slope));
  CHECK(history.last.velocity.head<2>().dot(along) == Approx(10 + 2 * a).margin(1e-9));
  CHECK(history.last.velocity.head<2>().dot(up) == Approx(0).margin(1e-9));
  CHECK(history.last.position.head<2>().dot(up) == Approx(0.5).margin(1e-9));
  CHECK(history.impact_count == 0);
}

TEST_CASE("a disk that cannot turn slides over 1000 segments as over one") {
  const double slope = GENERATE(0.0, 0.2);
  Material material(0.5, 0.3);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  Bench bench(ground(50, slope, 1000), material, settings);
  const Vec2 up(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  bench.add(disk(0.5, 1000, -30 * along + 0.5 * up, 10 * along));
  bench.world.bodies[0].inertia = 1e30;
  const BodyHistory& history = bench.run(2);
  const double a = 9.81 * (std::sin(slope) - 0.3 * std::cos(slope));
  CHECK(history.last.velocity.head<2>().dot(along) == Approx(10 + 2 * a).margin(1e-9));
  CHECK(history.last.position.head<2>().dot(up) == Approx(0.5).margin(1e-9));
  CHECK(history.impact_count == 0);
}
