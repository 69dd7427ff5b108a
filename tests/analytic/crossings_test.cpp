// Gates and barriers against the parabola, and shares of modes of travel against closed forms.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "math/travel_time.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace crossings_test {

namespace {

const double g = 9.81;

/// A disk of 0.5 m and 1000 kg that flies from (0, 10) at 10 m/s with 2 rad/s; it lands at x = 13.9 m.
struct Flyer {
  Material material{0, 0.5};
  Bench bench{ground(50), material};
  std::vector<Gate> gates;
  std::vector<Barrier> barriers;

  Flyer() { bench.add(disk(0.5, 1000, {0, 10}, {10, 0}, 2)); }
  const BodyHistory& run() {
    bench.run_settings.gates = gates;
    bench.run_settings.barriers = barriers;
    return bench.run(30);
  }
  double inertia() const { return bench.world.bodies[0].inertia; }
};

/// At x = 5: after 0.5 s.
const double height_at_5 = 10 - 0.5 * g * 0.25;
const double speed_at_5 = std::hypot(10.0, 0.5 * g);

}  // namespace

TEST_CASE("a gate sees the parabola, once, and does not disturb it") {
  Flyer plain, gated;
  gated.gates = {{5}, {20}, {-3}};
  const double undisturbed = plain.run().last.position.x();
  const BodyHistory& history = gated.run();
  CHECK(history.last.position.x() == undisturbed);
  REQUIRE(history.passages.size() == (undisturbed > 20 ? 2 : 1));
  const Passage& passage = history.passages[0];
  CHECK(passage.gate == 0);
  CHECK(passage.time == Approx(0.5).epsilon(1e-14));
  CHECK(passage.height == Approx(height_at_5).epsilon(1e-14));
  CHECK(passage.speed == Approx(speed_at_5).epsilon(1e-14));
  CHECK(passage.kinetic_energy ==
        Approx(500 * speed_at_5 * speed_at_5 + 0.5 * gated.inertia() * 4).epsilon(1e-14));
}

TEST_CASE("a gate on the left sees what flies to the left") {
  Flyer flyer;
  flyer.bench.world.bodies[0].v = {-10, 0};
  flyer.gates = {{-5}};
  REQUIRE(flyer.run().passages.size() == 1);
  CHECK(flyer.bench.histories[0].passages[0].time == Approx(0.5));
}

TEST_CASE("a barrier catches, is passed over, or takes its capacity") {
  Flyer flyer;
  const double energy = 500 * speed_at_5 * speed_at_5 + 0.5 * flyer.inertia() * 4;
  const double radius = std::cbrt(0.75 * flyer.bench.world.bodies[0].volume / pi);
  SECTION("caught where the capacity suffices") {
    flyer.barriers = {{5, height_at_5 + radius + 0.001, energy * (1 + 1e-9)}};
    const BodyHistory& history = flyer.run();
    REQUIRE(history.barriers.size() == 1);
    CHECK(history.barriers[0].outcome == BarrierOutcome::caught);
    CHECK(history.reason == StopReason::caught);
    CHECK(history.last.position.x() == Approx(5).epsilon(1e-14));
    CHECK(history.last.time == Approx(0.5));
    CHECK(history.max_distance == Approx(5));
  }
  SECTION("over the top where the radius of the rock does not fit") {
    flyer.barriers = {{5, height_at_5 + radius - 0.001, 1e9}};
    Flyer plain;
    const BodyHistory& history = flyer.run();
    REQUIRE(history.barriers.size() == 1);
    CHECK(history.barriers[0].outcome == BarrierOutcome::over_top);
    CHECK(history.last.position.x() == Approx(plain.run().last.position.x()).margin(1e-6));
  }
  SECTION("over energy: three quarters taken, half the speed and spin left") {
    flyer.barriers = {{5, 20, 0.75 * energy}};
    flyer.gates = {{5}, {5.001}};
    const BodyHistory& history = flyer.run();
    CHECK(history.barriers.at(0).outcome == BarrierOutcome::over_energy);
    CHECK(history.barriers[0].kinetic_energy == Approx(energy));
    REQUIRE(history.passages.size() == 2);
    CHECK(history.passages[0].kinetic_energy ==
          Approx(energy));  // a gate at the same place sees what arrives
    const double after = history.passages[1].kinetic_energy;
    CHECK(after == Approx(0.25 * energy).epsilon(1e-3));
    // It lands with 5 m/s and 1 rad/s, and comes to roll at (v - k R w) / (1 + k).
    CHECK(history.last.spin.z() == Approx(-(5 - 0.5 * 0.5 * 1) / 1.5 / 0.5).epsilon(1e-6));
  }
}

TEST_CASE(
    "a fence along a line in 3D does to a sphere what the fence across x does, where the sphere crosses it") {
  Material material(0.4, 0.5);
  const Vec3 start(0, 0, 10), velocity(10, 4, 0);
  const auto run = [&](const PlanLine& line, double height, double capacity) {
    Bench3 bench(plane(), material);
    bench.add(sphere(0.5, 1000, start, velocity, {1, 2, 3}));
    const std::vector<Gate> gates = {{line}};
    const std::vector<Barrier> barriers = {{line, height, capacity}};
    bench.run_settings.gates = gates;
    bench.run_settings.barriers = barriers;
    return bench.run(30);
  };
  // At x = 5: after 0.5 s, at y = 2.
  const PlanLine across(5), straight({{5, -1}, {5, 3}}), bent({{0, 7}, {5, 2}, {5, 1}}),
      beside({{5, 2.1}, {5, 9}});
  const double energy = run(across, 20, 1e9).barriers.at(0).kinetic_energy;
  for (const double height : {height_at_5 + 0.499, height_at_5 + 0.501})
    for (const double capacity : {0.75 * energy, 1.001 * energy}) {
      const BodyHistory expected = run(across, height, capacity);
      for (const PlanLine& line : {straight, bent}) {
        const BodyHistory history = run(line, height, capacity);
        REQUIRE(history.barriers.size() == 1);
        CHECK(history.barriers[0].outcome == expected.barriers[0].outcome);
        CHECK(history.barriers[0].outcome == (height < height_at_5 + 0.5 ? BarrierOutcome::over_top
                                              : capacity < energy        ? BarrierOutcome::over_energy
                                                                         : BarrierOutcome::caught));
        CHECK(history.passages.at(0).time == Approx(0.5).epsilon(1e-12));
        CHECK(history.passages[0].height == Approx(height_at_5).epsilon(1e-12));
        CHECK((history.last.position - expected.last.position).norm() < 1e-6);
      }
    }
  CHECK(run(beside, 20, 1e9).barriers.empty());
}

TEST_CASE("a barrier stops what slides or rolls, to a hundredth of a step") {
  Material material(0, 0.3);
  Bench bench(ground(50), material);
  bench.add(disk(0.5, 1000, {0, 0.5}, {6, 0}));
  const std::vector<Barrier> barriers = {{10, 2, 1e6}};
  bench.run_settings.barriers = barriers;
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(6);
  CHECK(history.reason == StopReason::caught);
  CHECK(history.last.position.x() == Approx(10).margin(6e-5));
  REQUIRE(history.barriers.size() == 1);
  CHECK(history.barriers[0].speed == Approx(4).epsilon(1e-6));  // it rolls by then, at 2/3 of 6 m/s
  CHECK(history.barriers[0].kinetic_energy == Approx(0.75 * 1000 * 16).epsilon(1e-5));
}

TEST_CASE("time and path by mode of travel") {
  SECTION("slide, then roll") {
    Material material(0, 0.3);
    Bench bench(ground(50), material);
    bench.add(disk(0.5, 1000, {0, 0.5}, {6, 0}));
    bench.run_settings.stop_speed = 0;
    const Travel& travel = bench.run(3).travel;
    // The slip v - R w falls at 3 mu g from 6 m/s; it slides until the slip is a twentieth of v.
    const double roll_from = 6 * (1 - 0.05) / ((3 - 0.05) * 0.3 * g);
    CHECK(travel.time[static_cast<int>(TravelMode::slide)] == Approx(roll_from).margin(2e-3));
    CHECK(travel.time[static_cast<int>(TravelMode::roll)] == Approx(3 - roll_from).margin(2e-3));
    CHECK(travel.time[static_cast<int>(TravelMode::flight)] == 0);
    CHECK(travel.distance[static_cast<int>(TravelMode::slide)] ==
          Approx(6 * roll_from - 0.15 * g * roll_from * roll_from).margin(0.02));
  }
  SECTION("flight, then bounces, on paths of known length") {
    Material material(1, 0);
    Bench bench(ground(50), material);
    bench.add(disk(0.5, 1000, {0, 10}, {3, 0}));
    const Travel& travel = bench.run(4).travel;
    const double fall = std::sqrt(2 * 9.5 / g);
    CHECK(travel.time[0] == Approx(fall).epsilon(1e-9));
    CHECK(travel.time[1] == Approx(4 - fall).epsilon(1e-9));
    // Simpson's rule over the fall, 1000 panels.
    double length = 0;
    const int n = 1000;
    for (int i = 0; i <= n; ++i)
      length += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * std::hypot(3.0, g * fall * i / n) * fall / n / 3;
    CHECK(travel.distance[0] == Approx(length).epsilon(1e-9));
  }
}

TEST_CASE("an arrival behind a turn keeps its digits") {
  // Away from a place just ahead at 10 m/s, and pushed back by 1 m/s2: it is reached after 20 s.
  CHECK(travel_times(1e-10, -10, 1)[0] == Approx(20).epsilon(1e-11));
  CHECK(travel_times(1e-10, -10, -1)[0] == std::numeric_limits<double>::infinity());
}

}  // namespace crossings_test
