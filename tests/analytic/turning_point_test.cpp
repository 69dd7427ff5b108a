// A step that ends where a body turns round does not shorten the steps after it.

#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a box that rocks up on a corner and back takes no shower of short steps where it turns") {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  Material material(0, 1);
  Bench bench(ground(100), material, settings);
  const double side = 1, tilt = 0.3;
  Body<2> block = box(side, side, 100, Vec2::Zero(), tilt);
  const Vec2 corner = block.attitude.rotation * Vec2(-side / 2, -side / 2);  // it rests on this one
  block.x = -corner;
  block.w = 0.8;  // away from the ground: it turns round before it would topple
  block.v = -cross(block.w, corner);
  bench.add(std::move(block));
  bench.run_settings.stop_speed = 0;
  bench.run(0.3);
  const Body<2>& end = bench.world.bodies[0];
  REQUIRE(end.w < 0);  // it has turned round and falls back
  const SolverQuality& quality = bench.world.quality();
  CHECK(quality.impact_problems == 0);
  CHECK(quality.steps < 24);
  CHECK(quality.energy_relative_change == Approx(0).margin(1e-3));
}
