// Walls and rounded squares on profiles, against closed forms. All at the default settings.

#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab.h"
#include "collision/pairs.h"
#include "scratch.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace wall_test {

namespace {

constexpr double gravity = 9.81;

Body<2> wall(double length, double radius, double mass, const Vec2& at, double angle = 0) {
  Body<2> body = make_body({Contactor2::wall({-length / 2, 0}, {length / 2, 0}, radius)}, 0, mass, 0);
  body.move_to(at, angle);
  return body;
}

Body<2> rounded_square(double side, double rounding, double mass, const Vec2& at, double angle = 0) {
  const double half = side / 2 - rounding;
  Body<2> body = make_body(
      {Contactor2::hull({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, rounding)}, 0, mass, 0);
  body.move_to(at, angle);
  return body;
}

}  // namespace

TEST_CASE("a wall on an incline rests, or slides with g (sin - mu cos), over one segment as over many") {
  const double slope = 20 * pi / 180, radius = 0.1, mu = GENERATE(0.5, 0.2);
  const int segments = GENERATE(1, 37);
  const Vec2 way(std::cos(slope), -std::sin(slope)), normal(std::sin(slope), std::cos(slope));
  Material material(0, mu);
  Bench bench(ground(10, slope, segments), material);
  bench.add(wall(0.6, radius, 400, radius * normal, -slope));
  const BodyHistory& history = bench.run(1);
  const double a = std::max(0.0, gravity * (std::sin(slope) - mu * std::cos(slope)));
  const Vec3 moved = history.last.position - history.first.position;
  CHECK((moved.head<2>() - 0.5 * a * way).norm() < 1e-6);
  CHECK((a > 0 || history.reason == StopReason::stopped));
}

TEST_CASE(
    "a rounded square on an incline rests, or slides with g (sin - mu cos), over one segment as over many") {
  const double slope = 20 * pi / 180, mu = GENERATE(0.5, 0.2);
  const int segments = GENERATE(1, 37);
  const Vec2 way(std::cos(slope), -std::sin(slope)), normal(std::sin(slope), std::cos(slope));
  Material material(0, mu);
  Bench bench(ground(10, slope, segments), material);
  bench.add(rounded_square(0.6, 0.1, 400, 0.3 * normal, -slope));
  const BodyHistory& history = bench.run(1);
  const double a = std::max(0.0, gravity * (std::sin(slope) - mu * std::cos(slope)));
  const Vec3 moved = history.last.position - history.first.position;
  CHECK((moved.head<2>() - 0.5 * a * way).norm() < 1e-6);
  CHECK((a > 0 || history.reason == StopReason::stopped));
}

TEST_CASE("a square that is rounded to a disk moves as a disk: it slides, rolls and bounces over corners") {
  Profile profile;
  profile.points = {{-10, 0}, {2, 0}, {3, -1}, {5, -1}, {6, -2.5}, {20, -2.5}};
  profile.part.assign(5, 0);
  profile.parts = {""};
  Material material(0.4, 0.3);
  const auto last = [&](Body<2> body) {
    Bench bench(profile, material);
    body.v = {4, 0};
    body.w = 5;
    bench.add(std::move(body));
    bench.run_settings.stop_speed = 0;
    return bench.run(2.5).last;
  };
  const auto square = last(rounded_square(1, 0.5 * (1 - 1e-9), 400, {0, 0.5}));
  const auto round = last(disk(0.5, 400, {0, 0.5}));
  CHECK(round.position.x() > 6);
  CHECK((square.position - round.position).norm() < 1e-6);
  CHECK((square.velocity - round.velocity).norm() < 1e-5);
  CHECK((square.spin - round.spin).norm() < 1e-5);
}

TEST_CASE("a wall that falls askew without friction bounces about its lower end") {
  const double length = 0.6, radius = 0.1, mass = 400, angle = pi / 6, e = GENERATE(0.0, 0.5, 1.0);
  Material material(e, 0);
  Bench bench(ground(10), material);
  const int i = bench.add(wall(length, radius, mass, {0, 1 + radius + length / 2 * std::sin(angle)}, angle));
  const double t = std::sqrt(2 / gravity), lever = length / 2 * std::cos(angle), v = gravity * t;
  const double share = mass * lever * lever / bench.world.bodies[i].inertia;
  bench.run(t + 1e-3);
  const Body<2>& body = bench.world.bodies[i];
  const double push = (1 + e) * v / (1 + share);
  CHECK(body.w == Approx(-lever * mass * push / bench.world.bodies[i].inertia).epsilon(e > 0 ? 1e-9 : 2e-2));
  CHECK(body.v.y() == Approx(push - v - gravity * 1e-3).epsilon(e > 0 ? 1e-9 : 2e-2));
}

TEST_CASE(
    "a wall that hangs over a bench tips where its centre is beyond the edge, and rests where it is not") {
  const double inside = GENERATE(0.05, -0.05), radius = 0.1;
  Profile profile;
  profile.points = {{-10, 1}, {0, 1}, {0.5, -3}, {10, -3}};
  profile.part.assign(3, 0);
  profile.parts = {""};
  Material material(0, 0.8);
  Bench bench(profile, material);
  bench.add(wall(0.8, radius, 400, {-inside, 1 + radius}));
  const BodyHistory& history = bench.run(2);
  if (inside > 0) {
    CHECK(history.reason == StopReason::stopped);
    CHECK((history.last.position - history.first.position).norm() < 1e-6);
  } else {
    CHECK(history.last.position.y() < 0);
  }
}

TEST_CASE("thrown walls lose energy on a rugged profile and stay above it") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> random(-1, 1);
    Profile profile;
    for (int k = 0; k <= 60; ++k) profile.points.push_back({0.4 * k - 10, -0.15 * k + 0.15 * random(rng)});
    profile.part.assign(60, 0);
    profile.parts = {""};
    Material material(0.4, 0.5, 0.02);
    Bench bench(profile, material);
    const int i = bench.add(wall(0.7, 0.15, 400, {-8 + random(rng), 3}, 3 * random(rng)));
    Body<2>& body = bench.world.bodies[i];
    body.v = {3, 3 * random(rng)};
    body.w = 20 * random(rng);
    const auto energy = [&](const Body<2>& b) {
      return 0.5 * b.mass * b.v.squaredNorm() + 0.5 * b.inertia * b.w * b.w + b.mass * gravity * b.x.y();
    };
    const double before = energy(body);
    const BodyHistory& history = bench.run(5);
    const Body<2>& last = bench.world.bodies[i];
    CHECK(history.reason != StopReason::diverged);
    CHECK(energy(last) < before);
    const Placed2 placed{last.contactors[0], {last.x, Rotation2::from_angle(last.attitude.angle)}};
    std::vector<ContactPoint<2>> contacts;
    terrain_contacts(scratch(), placed, bench.terrain, 0, 0, contacts);
    for (const auto& c : contacts) CHECK(c.gap > -1e-4);
    for (int end = 0; end < 2; ++end)
      CHECK(placed.point(end).y() > bench.terrain.height(placed.point(end).x()));
  }
}

}  // namespace wall_test
