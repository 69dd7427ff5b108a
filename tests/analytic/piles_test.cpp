// Piles at rest: a stack, a wall, a block on a slope. An exact rigid solution neither sinks nor creeps.

#include <catch2/catch.hpp>
#include <ctime>
#include <iostream>

#include "lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

/// Steps a pile for 5 s at 1/240 s; prints what a step costs in processor time.
void rest(const char* name, Bench& bench) {
  constexpr double h = 1.0 / 240;
  constexpr int steps = 1200;
  const std::clock_t begin = std::clock();
  for (int k = 0; k < steps; ++k) bench.world.step(h, false);
  const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
  const SolverQuality& quality = bench.world.quality();
  std::cout << name << ": " << bench.world.contacts().size() << " contacts, " << ms << " ms a step, "
            << static_cast<double>(quality.iterations) / steps << " iterations a step, "
            << quality.not_converged << " of " << steps << " not converged\n";
}

}  // namespace

TEST_CASE("a stack of ten boxes stands: every step converges, nothing sinks") {
  Material material(0, 0.6);
  WorldSettings settings;
  settings.time_step = 1.0 / 240;
  Bench bench(ground(10), material, settings);
  for (int i = 0; i < 10; ++i) bench.add(box(1, 1, 2700, {0, 0.5 + i}));
  rest("stack of ten boxes", bench);
  CHECK(bench.world.quality().not_converged == 0);
  for (int i = 0; i < 10; ++i) {
    CHECK(std::abs(bench.world.bodies[i].x.y() - (0.5 + i)) < 1e-6);
    CHECK(std::abs(bench.world.bodies[i].x.x()) < 1e-6);
  }
}

TEST_CASE("chosen steps of a stack at rest are long: what rounding moves is no sliding") {
  Material material(0, 0.6);
  Bench bench(ground(10), material, {.step_tolerance = 1e-3});
  for (int i = 0; i < 10; ++i) bench.add(box(1, 1, 2700, {0.01 * (i % 3), 0.5 + i}));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  CHECK(bench.world.quality().steps < 120);  // of 20 ms; before, of the least length
  CHECK(bench.world.bodies[9].x.y() == Approx(9.5).epsilon(1e-9));
}

TEST_CASE("a wall of a hundred bricks stands and does not sink", "[slow]") {
  Material material(0, 0.6);
  WorldSettings settings;
  settings.time_step = 1.0 / 240;
  Bench bench(ground(30), material, settings);
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 10; ++i)
      bench.add(box(1, 0.5, 675, {1.01 * i + (row % 2 ? 0.25 : 0), 0.25 + 0.5 * row}));
  rest("wall of a hundred bricks", bench);
  CHECK(bench.world.quality().not_converged == 0);
  for (int k = 0; k < 100; ++k) {
    const double x = 1.01 * (k % 10) + (k / 10 % 2 ? 0.25 : 0), y = 0.25 + 0.5 * (k / 10);
    CHECK(std::abs(bench.world.bodies[k].x.y() - y) < 1e-6);
    CHECK(std::abs(bench.world.bodies[k].x.x() - x) < 1e-6);
  }
}

TEST_CASE("a block on a slope stays or slides, on the right side of sticking, and does not creep") {
  constexpr double h = 1.0 / 240, mu = 0.5;
  for (const double share : {0.98, 1.02}) {
    const double slope = std::atan(share * mu);
    Material material(0, mu);
    WorldSettings settings;
    settings.time_step = h;
    settings.tolerance = 1e-8;
    Bench bench(ground(50, slope), material, settings);
    const Vec2 normal(std::sin(slope), std::cos(slope));
    bench.add(box(1, 0.5, 1000, 0.25 * normal, -slope));
    for (int k = 0; k < 1200; ++k) {
      bench.world.step(h, false);
      if (share < 1) REQUIRE(bench.world.bodies[0].v.norm() < 1e-9);
    }
    if (share < 1) continue;
    const double expected = 9.81 * (std::sin(slope) - mu * std::cos(slope)) * 5;
    CHECK(bench.world.bodies[0].v.norm() == Approx(expected).epsilon(1e-6));
  }
}
