// Bodies of space that meet each other.
#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab_3d.h"
#include "geometry/hull.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a box stands on a box, askew") {
  Material material(0.3, 0.5);
  WorldSettings settings;
  settings.tolerance = 1e-8;
  settings.max_iterations = 100000;
  Bench3 bench(plane(), material, settings);
  bench.add(box({1, 0.8, 0.5}, 1000, {0, 0, 0.25}));
  bench.add(box({0.6, 0.6, 0.4}, 400, {0.05, 0.1, 0.7}, Vec3(0.8, 0.6, 0)));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  for (const BodyHistory& history : bench.histories) {
    CHECK((history.last.position - history.first.position).norm() < 1e-8);
    CHECK(history.last.velocity.norm() < 1e-8);
  }
  CHECK(bench.world.quality().not_converged == 0);
}

TEST_CASE(
    "two spheres that strike each other keep their momentum and lose (1 - e^2) of the energy of approach") {
  const double e = 0.5;
  Material material(e, 0);
  Bench3 bench(plane(), material, {}, Vec3::Zero());
  const Vec3 way = Vec3(2, 1, 2).normalized();
  bench.add(sphere(0.2, 1, {0, 0, 5}, 3 * way));
  bench.add(sphere(0.3, 2, Vec3(0, 0, 5) + 2 * way, -1 * way));
  bench.run(1.5);
  const auto& bodies = bench.world.bodies;
  CHECK((bodies[0].v + 2 * bodies[1].v - way).norm() < 1e-12);  // 1 x 3 - 2 x 1
  CHECK((bodies[1].v - bodies[0].v - 4 * e * way).norm() < 1e-9);
  REQUIRE(bench.histories[0].impacts.size() == 1);
  CHECK(bench.histories[0].impacts[0].energy_change ==
        Approx(-0.5 * (2.0 / 3) * 16 * (1 - e * e)).epsilon(1e-9));
  CHECK(bench.histories[0].impacts[0].time == Approx(1.5 / 4).epsilon(1e-9));
}

TEST_CASE("polyhedra that fall on each other overlap by less than half a millimetre", "[slow]") {
  Material material(0.2, 0.6);
  Bench3 bench(plane(), material);
  std::mt19937 rng(GENERATE(7, 8));
  const auto uniform = [&](double a, double b) { return a + (b - a) * (rng() / 4294967296.0); };
  for (int k = 0; k < 24; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 14; ++i)
      points.push_back(0.27 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized());
    Body<3> rock = make_body({convex_hull(points)}, 2700, 0);
    rock.x = {uniform(0, 0.3), uniform(0, 0.2), 1.0 + k};
    bench.add(rock);
  }
  bench.run(5);
  CHECK(bench.world.quality().max_penetration < 5e-4);
}
