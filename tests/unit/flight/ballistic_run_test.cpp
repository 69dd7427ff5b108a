// What the method ballistic keeps of a flight, against the parabola.

#include <catch2/catch.hpp>

#include "flight/point_run.h"
#include "unit/flight/vacuum_range.h"

using namespace flyrock;

namespace {

constexpr double g = 9.81;

Terrain2 bench() {
  Profile ground;
  ground.points = {{-50, 12}, {0, 12}, {4, 0}, {600, 0}};
  ground.part = {0, 0, 0};
  ground.parts = {""};
  return Terrain2(ground);
}

Body<2> rock(const Vec2& position, const Vec2& velocity) {
  Body<2> body = make_body({Contactor2::disk(0.1, Vec2::Zero())}, 2700, 0, 0);
  body.move_to(position, 0);
  body.v = velocity;
  body.w = 2;
  return body;
}

PointRun<2> without_air() {
  PointRun<2> run;
  run.forces.gravity = {0, -g};
  return run;
}

}  // namespace

TEST_CASE("a flight over a bench keeps the numbers of its parabola") {
  const Body<2> body = rock({-2, 13}, {20, 10});
  PointRun<2> run = without_air();
  run.trajectory_every = 0.1;
  const BodyHistory h = run_point(body, bench(), run);
  const double range = vacuum_range(std::hypot(20, 10), std::atan2(10, 20), 13, g);
  CHECK(h.reason == StopReason::stopped);
  CHECK(h.flight_range == Approx(range).epsilon(1e-12));
  CHECK(h.max_distance == Approx(range).epsilon(1e-12));
  CHECK(h.last.time == Approx(range / 20).epsilon(1e-12));
  CHECK(h.stop_time == h.last.time);
  CHECK(h.max.position.y() == Approx(13 + 100 / (2 * g)).epsilon(1e-12));
  CHECK(h.bounce_height == Approx(13 + 100 / (2 * g)).epsilon(1e-12));  // the apex lies beyond the toe
  CHECK(h.max_speed == Approx(std::sqrt(500 + 2 * g * 13)).epsilon(1e-12));
  CHECK(h.last.angle == Approx(2 * h.last.time).epsilon(1e-12));
  CHECK(h.max.kinetic_energy ==
        Approx(0.5 * body.mass * (500 + 2 * g * 13) + 2 * body.inertia).epsilon(1e-12));
  double path = 0;
  for (int i = 0; i < 100000; ++i)
    path += std::hypot(20, 10 - g * (i + 0.5) * h.last.time / 1e5) * h.last.time / 1e5;
  CHECK(h.travel.distance[0] == Approx(path).epsilon(1e-9));
  CHECK(h.travel.time[0] == Approx(h.last.time).epsilon(1e-12));
  CHECK(h.impact_count == 0);
  REQUIRE(h.trajectory.size() == static_cast<std::size_t>(h.last.time / 0.1) + 2);
  CHECK((h.trajectory[10].state.position.head<2>() - Vec2(18, 13 + 10 - g / 2)).norm() < 1e-9);
}

TEST_CASE("the greatest height above the ground may be above a toe, or along a slope") {
  // Level above the floor after the toe and falling: highest above the toe itself.
  const BodyHistory level = run_point(rock({-1, 12.5}, {30, 0}), bench(), without_air());
  const double t = 5 / 30.0;
  CHECK(level.bounce_height == Approx(12.5 - g * t * t / 2).epsilon(1e-9));
  Profile slope;  // down at 45 degrees: farthest from it in the vertical where the path is parallel to it
  slope.points = {{-10, 10}, {500, -500}};
  slope.part = {0};
  slope.parts = {""};
  const BodyHistory down = run_point(rock({0, 0.1}, {20, 0}), Terrain2(slope), without_air());
  CHECK(down.bounce_height == Approx(0.1 + 20 * 20 / (2 * g)).epsilon(1e-9));
}

TEST_CASE("flights that leave or run out of time say so") {
  CHECK(run_point(rock({-20, 13}, {-30, 20}), bench(), without_air()).reason == StopReason::left_domain);
  PointRun<2> run = without_air();
  run.stop_time = 1;
  const BodyHistory timed = run_point(rock({0, 13}, {1, 20}), bench(), run);
  CHECK(timed.reason == StopReason::timed_out);
  CHECK(timed.last.time == 1);
  CHECK(std::isnan(timed.stop_time));
  run.start_time = 2;  // its hole goes off when the time is up
  const BodyHistory never = run_point(rock({0, 13}, {1, 20}), bench(), run);
  CHECK(never.reason == StopReason::timed_out);
  CHECK(never.last.time == 2);
  CHECK(never.last.position.y() == 13);
  CHECK(never.flight_range == 0);
}

TEST_CASE("the bins along x hold the heights and speeds of a flight with drag") {
  PointRun<2> run = without_air();
  run.forces.air.drag = 0.0034;
  run.bin_width = 10;
  const BodyHistory h = run_point(rock({0, 12}, {42, 42}), bench(), run);
  double highest = 0, fastest = 0;
  for (const PathBin& bin : h.path.bins()) {
    highest = std::max(highest, bin.height);
    fastest = std::max(fastest, bin.speed);
  }
  CHECK(highest == Approx(h.bounce_height).epsilon(1e-3));
  CHECK(fastest == Approx(h.max_speed).epsilon(1e-9));
  CHECK(static_cast<double>(h.path.bins().size()) == Approx(h.flight_range / 10).margin(1.01));
}

TEST_CASE(
    "gates see a flight pass, and fences catch it, let it over the top, or through with what energy is "
    "left") {
  const Body<2> body = rock({0, 12}, {20, 10});
  const double range = vacuum_range(std::hypot(20, 10), std::atan2(10, 20), 12, g);
  const auto height = [&](double x) { return 12 + x / 2 - g * x * x / 800; };
  PointRun<2> run = without_air();
  const std::vector<Gate> gates{{30}, {range + 1}};
  run.gates = gates;
  const BodyHistory free = run_point(body, bench(), run);
  REQUIRE(free.passages.size() == 1);
  CHECK(free.passages[0].time == Approx(1.5).epsilon(1e-12));
  CHECK(free.passages[0].height == Approx(height(30)).epsilon(1e-12));
  CHECK(free.passages[0].speed == Approx(std::hypot(20, 10 - 1.5 * g)).epsilon(1e-12));

  const double energy = free.passages[0].kinetic_energy;
  CHECK(energy ==
        Approx(0.5 * (body.mass * std::pow(free.passages[0].speed, 2) + 4 * body.inertia)).epsilon(1e-12));
  const auto fenced = [&](double high, double capacity) {
    const std::vector<Barrier> fence{{30, high, capacity}};
    run.barriers = fence;
    return run_point(body, bench(), run);
  };
  const BodyHistory caught = fenced(height(30) + 0.11, 1.01 * energy);
  CHECK(caught.reason == StopReason::caught);
  CHECK(caught.last.position.x() == Approx(30).epsilon(1e-12));
  CHECK(caught.last.time == Approx(1.5).epsilon(1e-12));
  const BodyHistory over = fenced(height(30) + 0.09, 1e9);
  CHECK(over.barriers.at(0).outcome == BarrierOutcome::over_top);
  CHECK(over.flight_range == Approx(range).epsilon(1e-12));
  const BodyHistory through = fenced(height(30) + 1, 0.36 * energy);
  CHECK(through.barriers.at(0).outcome == BarrierOutcome::over_energy);
  const Vec2 slower = 0.8 * Vec2(20, 10 - 1.5 * g);
  CHECK(through.flight_range ==
        Approx(30 + vacuum_range(slower.norm(), std::atan2(slower.y(), slower.x()), height(30), g))
            .epsilon(1e-12));
  // It has turned at 2 rad/s up to the fence, and at 0.8 of it behind.
  CHECK(through.last.angle == Approx(2 * (1.5 + 0.8 * (through.last.time - 1.5))).epsilon(1e-12));
}

TEST_CASE("in 3D a flight meets a fence along a line where it crosses it, with and without drag") {
  Plane ground;
  ground.normal = Vec3::UnitZ();
  Body<3> body = make_body({Contactor3::sphere(0.1)}, 2700, 0);
  body.x = {0, 0, 12};
  body.v = {20, 10, 5};
  for (const double drag : {0.0, 0.01}) {
    const auto flown = [&](const PlanLine& line, double height) {
      PointRun<3> run;
      run.forces = {{0, 0, -g}, {drag, Vec3::Zero()}};
      const std::vector<Gate> gates{{line}};
      const std::vector<Barrier> barriers{{line, height, 1e9}};
      run.gates = gates;
      run.barriers = barriers;
      return run_point(body, Terrain3(ground), run);
    };
    const BodyHistory across = flown(PlanLine(18), 100);  // there y = 9
    CHECK(across.reason == StopReason::caught);
    CHECK((across.last.position.head<2>() - Vec2(18, 9)).norm() < 1e-9);
    const double height = across.barriers.at(0).height;
    const PlanLine bent({{-30, 5}, {10, 17}, {26, 1}, {26, -20}});
    const BodyHistory caught = flown(bent, height + 0.11);
    CHECK(caught.reason == StopReason::caught);
    CHECK((caught.last.position - across.last.position).norm() < 1e-8);
    REQUIRE(caught.passages.size() == 1);
    CHECK(caught.passages[0].kinetic_energy == Approx(across.passages.at(0).kinetic_energy).epsilon(1e-9));
    CHECK(flown(bent, height + 0.09).barriers.at(0).outcome == BarrierOutcome::over_top);
    CHECK(flown(PlanLine({{10, 17}, {17, 10}}), 100).barriers.empty());
  }
}

TEST_CASE("a partial factor on heights lowers what a fence holds, and the radius counts once") {
  const Barrier fence{.line = 5, .height = 3, .capacity = 1000, .height_factor = 1.25};
  const double volume = 4 * pi / 3 * 0.125;  // radius 0.5 m
  const auto outcome = [&](double height, double energy) {
    return meet(fence, 0, {.kinetic_energy = energy, .height = height}, volume).outcome;
  };
  CHECK(outcome(1.999, 1000) == BarrierOutcome::caught);
  CHECK(outcome(2.001, 1000) == BarrierOutcome::over_top);
  CHECK(outcome(1.999, 1001) == BarrierOutcome::over_energy);
}

TEST_CASE("in space a flight lands on its plane, and turns with the azimuth of the launch") {
  Plane ground;
  ground.normal = Vec3(0.1, -0.2, 1).normalized();
  const auto flown = [&](double azimuth, double drag) {
    Body<3> body = make_body({Contactor3::sphere(0.1)}, 2700, 0);
    body.x = {0, 0, 12};
    body.v = {20 * std::cos(azimuth), 20 * std::sin(azimuth), 15};
    PointRun<3> run;
    run.forces = {{0, 0, -g}, {drag, Vec3::Zero()}};
    return run_point(body, Terrain3(ground), run);
  };
  // On the plane the flight lasts until 12 + 15 t - g t^2/2 = (-0.1 vx + 0.2 vy) t.
  for (const double azimuth : {0.0, 1.0, 4.0}) {
    const double slope = -0.1 * 20 * std::cos(azimuth) + 0.2 * 20 * std::sin(azimuth), up = 15 - slope;
    const BodyHistory h = flown(azimuth, 0);
    CHECK(h.reason == StopReason::stopped);
    CHECK(h.flight_range == Approx(20 * (up + std::sqrt(up * up + 2 * g * 12)) / g).epsilon(1e-12));
    CHECK(h.bounce_height == Approx(12 + up * up / (2 * g)).epsilon(1e-12));
    CHECK(std::atan2(h.last.position.y(), h.last.position.x()) ==
          Approx(std::remainder(azimuth, 2 * pi)).epsilon(1e-9));
    CHECK(flown(azimuth, 0.01).flight_range < 0.95 * h.flight_range);
  }
}
