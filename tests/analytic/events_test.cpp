// Events that fixed steps miss: fast bodies and thin obstacles, bounces in a corner, fast spin beside a wall.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a disk of 1 cm at 300 m/s never passes a thin terrain") {
  Material material(0.6, 0.5);
  // A blade of 1 mm on level ground.
  Profile profile;
  profile.points = {{-50, 0}, {0, 0}, {0.0005, 3}, {0.001, 0}, {50, 0}};
  profile.part.assign(4, 0);
  profile.parts = {""};
  for (int k = 0; k < 50; ++k) {
    Bench bench(profile, material);
    bench.add(disk(0.005, 1, {-10 - 0.013 * k, 1.2}, {300, 0.01 * k}));
    const BodyHistory& history = bench.run(0.5);
    REQUIRE(history.impact_count >= 1);
    REQUIRE(history.max.position.x() < 0.0005);
    CHECK(history.impacts.front().vn_before < -290);
  }
}

TEST_CASE("a square of 1 cm that slides at 300 m/s stops at a plate of 1 mm") {
  Material material(0.5, 0.3);
  Bench bench(ground(100), material);
  const int plate = bench.add(box(0.001, 0.5, 1, {20, 0.2501}));
  bench.world.bodies[plate].kind = BodyKind::fixed;
  const int slider = bench.add(box(0.01, 0.01, 1, {0, 0.005}));
  bench.world.bodies[slider].v = {300, 0};
  bench.run(0.3);
  const BodyHistory& history = bench.histories[slider];
  CHECK(history.max.position.x() < 20 - 0.0005 - 0.004999);
  CHECK(history.last.velocity.x() < 0);
}

TEST_CASE("a disk bounces 1000 times in a valley and stays in it") {
  Material material(1, 0);
  Profile profile;
  profile.points = {{-10, 10}, {0, 0}, {10, 10}};
  profile.part.assign(2, 0);
  profile.parts = {""};
  WorldSettings settings;
  settings.rest_speed = 1e-9;
  Bench bench(profile, material, settings);
  bench.add(disk(0.2, 1, {0.3, 3}));
  bench.run_settings.stop_time = 1e4;
  bench.run_settings.keep_impacts = false;
  const double energy = bench.world.total_energy();
  bench.run(800);
  CHECK(bench.histories[0].impact_count > 1000);
  CHECK(bench.world.total_energy() == Approx(energy).epsilon(1e-9));
  CHECK(bench.world.quality().max_penetration < 1e-9);
}

TEST_CASE("a square that spins with 500 rad/s beside a wall does not enter it") {
  Material material(0.5, 0.3);
  Profile profile;
  profile.points = {{-10, 0}, {5, 0}, {5, 10}, {10, 10}};
  profile.part.assign(3, 0);
  profile.parts = {""};
  Bench bench(profile, material);
  bench.add(box(1, 1, 100, {4, 5}));
  bench.world.bodies[0].w = 500;
  bench.world.bodies[0].v = {0.5, 0};
  const BodyHistory& history = bench.run(1);
  CHECK(history.impact_count >= 1);
  CHECK(bench.world.quality().max_penetration < 1e-6);
  CHECK(history.max.position.x() < 4.5 + 1e-6);
}

TEST_CASE("fixed steps and exact flight agree on a single bounce to first order in h") {
  Material material(0.6, 0);
  const auto apex = [&](bool exact, double h) {
    WorldSettings settings;
    settings.time_step = h;
    Bench bench(ground(10), material, settings);
    bench.add(disk(0.5, 1, {0, 10.5}));
    bench.run_settings.exact_flight = exact;
    bench.run(3);
    REQUIRE(bench.histories[0].apexes.size() >= 1);
    return bench.histories[0].apexes[0].height;
  };
  CHECK(apex(true, 1e-3) == Approx(3.6).epsilon(1e-12));
  CHECK(apex(false, 1e-3) == Approx(3.6).margin(0.02));
  CHECK(apex(false, 1e-5) == Approx(3.6).margin(0.0002));
}

TEST_CASE("a sphere bounces on another body as on the ground, each time after 2 v / g") {
  constexpr double e = 0.7, g = 9.81, radius = 0.3;
  for (const bool is_fixed : {true, false}) {  // else driven, at rest
    Material material(e, 0.3);
    Bench3 bench(plane(), material);
    Body<3> base = box({4, 4, 1}, 100, {0, 0, 5});
    base.kind = is_fixed ? BodyKind::fixed : BodyKind::driven;
    bench.add(base);
    const int ball = bench.add(sphere(radius, 1, {0, 0, 5.5 + radius + 1}));
    bench.run(2);
    const std::vector<Impact>& impacts = bench.histories[ball].impacts;
    REQUIRE(impacts.size() >= 4);
    double time = std::sqrt(2 / g), speed = std::sqrt(2 * g);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(std::abs(impacts[i].time - time) < 1e-13);
      speed *= e;
      time += 2 * speed / g;
    }
    CHECK(bench.world.quality().steps == 0);
  }
}
