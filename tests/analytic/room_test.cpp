// What is in drums, and what hangs on shafts, against closed forms. All at steps of 1 ms.

#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace room_test {

namespace {

constexpr double gravity = 9.81, inner = 1, outer = 1.05;

Profile far_below() {
  Profile floor = ground(50);
  for (Vec2& point : floor.points) point.y() = -20;
  return floor;
}

Plane plane_far_below() {
  Plane floor;
  floor.point = {0, 0, -20};
  return floor;
}

Body<2> drum(double spin, double radius = inner) {
  Body<2> body = make_body({Contactor2::hollow_disk(radius, 1.05 * radius)}, 1000, 0, 0);
  body.kind = BodyKind::driven;
  body.w = spin;
  return body;
}

/// A tube along y.
Body<3> tube(double radius, double wall, double length) {
  Body<3> body = make_body({Contactor3::hollow_cylinder(radius, wall, length)}, 1000, 0);
  body.attitude = Rotation3::from_vector({0.5 * pi, 0, 0}) * body.attitude.rotation;
  return body;
}

WorldSettings steps() {
  WorldSettings settings;
  settings.time_step = 1e-3;
  return settings;
}

/// How far the phase of a small swing is from where the closed form has it after a run [share of the swing].
template <class Bench>
double swing_error(Bench& bench, int body, double period, double arm, double start, double time) {
  bench.run_settings.stop_speed = 0;
  bench.run(time);
  const double expected = arm * std::sin(start * std::cos(2 * pi * time / period));
  return std::abs(bench.world.bodies[body].x.x() - expected) / (arm * start);
}

}  // namespace

TEST_CASE("a disk in a drum swings with 2 pi sqrt(3 (R - r)/(2 g))") {
  const double radius = GENERATE(0.05, 0.4), arm = inner - radius, start = 0.02;
  Material material(0, 2);
  Bench bench(far_below(), material, steps());
  bench.add(drum(0));
  const int i = bench.add(disk(radius, 3, arm * Vec2(std::sin(start), -std::cos(start))));
  CHECK(swing_error(bench, i, 2 * pi * std::sqrt(1.5 * arm / gravity), arm, start, 1.3) < 1e-3);
  CHECK(bench.world.quality().max_penetration < 1e-7);
}

TEST_CASE("a ball in a tube swings with 2 pi sqrt(7 (R - r)/(5 g)), and keeps its place along the tube") {
  const double radius = GENERATE(0.05, 0.4), arm = inner - radius, start = 0.02;
  Material material(0, 2);
  Bench3 bench(plane_far_below(), material, steps());
  Body<3> fixed = tube(inner, outer, 2);
  fixed.kind = BodyKind::fixed;
  bench.add(fixed);
  const int i = bench.add(sphere(radius, 3, arm * Vec3(std::sin(start), 0, -std::cos(start))));
  CHECK(swing_error(bench, i, 2 * pi * std::sqrt(1.4 * arm / gravity), arm, start, 1.3) < 1e-3);
  CHECK(std::abs(bench.world.bodies[i].x.y()) < 1e-9);
  CHECK(bench.world.quality().max_penetration < 1e-7);
}

TEST_CASE("a ring that hangs on a peg, and a tube on a shaft, swing with the moment of a ring") {
  const double peg = 0.1, hole = 0.5, arm = hole - peg, start = 0.02;
  const double wall = GENERATE(0.52, 0.8), share = 0.5 * (1 + wall * wall / (hole * hole));
  const double period = 2 * pi * std::sqrt(arm * (1 + share) / gravity);
  Material material(0, 2);
  const bool is_tube = GENERATE(false, true);
  if (is_tube) {
    Bench3 bench(plane_far_below(), material, steps());
    Body<3> shaft = make_body({Contactor3::cylinder(peg, 3)}, 1000, 0);
    shaft.attitude = Rotation3::from_vector({0.5 * pi, 0, 0}) * shaft.attitude.rotation;
    shaft.kind = BodyKind::fixed;
    bench.add(shaft);
    Body<3> body = tube(hole, wall, 0.7);
    body.x = arm * Vec3(std::sin(start), 0, -std::cos(start));
    const int i = bench.add(body);
    CHECK(swing_error(bench, i, period, arm, start, 1.3) < 1e-3);
  } else {
    Bench bench(far_below(), material, steps());
    Body<2> fixed = disk(peg, 1, {0, 0});
    fixed.kind = BodyKind::fixed;
    bench.add(fixed);
    Body<2> ring = make_body({Contactor2::hollow_disk(hole, wall)}, 1000, 0, 0.1);
    ring.x = arm * Vec2(std::sin(start), -std::cos(start));
    const int i = bench.add(ring);
    CHECK(swing_error(bench, i, period, arm, start, 1.3) < 1e-3);
  }
}

TEST_CASE("a drum that turns fast holds a slipping disk at rest where tan(phi) = mu") {
  const double mu = GENERATE(0.2, 0.6), radius = 0.2, arm = inner - radius, angle = std::atan(mu);
  Material material(0, mu);
  Bench bench(far_below(), material, steps());
  bench.add(drum(100));  // the wall at the bottom goes to the right
  const Vec2 place = arm * Vec2(std::sin(angle), -std::cos(angle));
  const int i = bench.add(disk(radius, 3, place));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  CHECK((bench.world.bodies[i].x - place).norm() < 1e-5);
  const double spun = 2 * mu * gravity * std::cos(angle) / radius;  // rad/s after 1 s: mu N r/J
  CHECK(bench.world.bodies[i].w == Approx(spun).epsilon(1e-4));
}

TEST_CASE("a box on its two lower corners slips in a turning drum, at rest where its forces balance") {
  const double mu = 0.3, width = 0.6, height = 0.2;
  const double beta = std::asin(0.5 * width / inner), arm = std::cos(beta) * inner - 0.5 * height;
  // The forces at the corners phi -+ beta follow from the balance of forces: each is N along the normal and
  // mu N along the wall. What is left is the moment about the centre of the drum.
  const auto moment = [&](double angle) {
    Eigen::Matrix2d balance;
    const auto force = [&](double at) {
      return Vec2(Vec2(-std::sin(at), std::cos(at)) + mu * Vec2(std::cos(at), std::sin(at)));
    };
    balance.col(0) = force(angle - beta);
    balance.col(1) = force(angle + beta);
    return mu * inner * (balance.inverse() * Vec2(0, gravity)).sum() - gravity * arm * std::sin(angle);
  };
  double low = 0, high = 1.2;
  for (int k = 0; k < 60; ++k) (moment(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  Material material(0, mu);
  Bench bench(far_below(), material, steps());
  bench.add(drum(20));
  const Vec2 place = arm * Vec2(std::sin(low), -std::cos(low));
  const int i = bench.add(box(width, height, 10, place, low));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  CHECK((bench.world.bodies[i].x - place).norm() < 1e-5);
  CHECK(bench.world.bodies[i].attitude.angle == Approx(low).margin(1e-5));
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("a disk, a wall and a polygon that bounce in a drum stay in it and gain no energy") {
  Material material(0.8, 0.4);
  Bench bench(far_below(), material, steps());
  bench.add(drum(0));
  const int kind = GENERATE(0, 1, 2);
  Body<2> body = kind == 0   ? disk(0.2, 3, {0.1, 0})
                 : kind == 1 ? make_body({Contactor2::wall({-0.3, 0}, {0.3, 0}, 0.1)}, 1000, 0, 0)
                             : box(0.5, 0.3, 3, {0.1, 0});
  body.v = {30, 10};
  body.w = 40;
  const int i = bench.add(body);
  const auto energy = [&] {
    const Body<2>& now = bench.world.bodies[i];
    return now.kinetic_energy() + now.mass * gravity * now.x.y();
  };
  const double before = energy();
  bench.run(1);
  CHECK(energy() < before);
  CHECK(bench.world.bodies[i].x.norm() < inner);
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("a ball, a box, a coin, a cone and a compound that bounce in a tube stay within its wall") {
  Material material(0.7, 0.4);
  Bench3 bench(plane_far_below(), material, steps());
  Body<3> fixed = tube(inner, outer, 400);
  fixed.kind = BodyKind::fixed;
  bench.add(fixed);
  const int kind = GENERATE(0, 1, 2, 3);
  Body<3> body =
      kind == 0   ? sphere(0.3, 3, Vec3::Zero())
      : kind == 1 ? box({0.5, 0.3, 0.4}, 3, Vec3::Zero())
      : kind == 2
          ? make_body({Contactor3::cylinder(0.4, 0.02)}, 1000, 0)
          : make_body({Contactor3::sphere(0.2, {0.2, 0, 0}), Contactor3::cylinder(0.15, 0.5)}, 1000, 0);
  body.v = {60, 5, 30};
  body.w = {30, 20, 50};
  const int i = bench.add(body);
  bench.run(0.6);
  CHECK(std::hypot(bench.world.bodies[i].x.x(), bench.world.bodies[i].x.z()) < inner);
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("a cylinder that falls along a tube comes to rest on both of its rims") {
  Material material(0.2, 0.5);
  Bench3 bench(plane_far_below(), material, steps());
  Body<3> fixed = tube(inner, outer, 4);
  fixed.kind = BodyKind::fixed;
  bench.add(fixed);
  const double radius = 0.3;
  Body<3> body = make_body({Contactor3::cylinder(radius, 0.5)}, 1000, 0);
  body.attitude = Rotation3::from_vector({0.5 * pi, 0, 0}) * body.attitude.rotation;
  body.x = {0, 0, -0.6};
  const int i = bench.add(body);
  bench.run(2);
  CHECK((bench.world.bodies[i].x - Vec3(0, 0, radius - inner)).norm() < 1e-5);
  CHECK(bench.world.bodies[i].v.norm() < 1e-4);
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE(
    "a box slides down a fixed half space as down a slope, and a half space that rises carries a ball") {
  const double slope = pi / 6, mu = 0.3, rate = 0.5;
  Material material(0, mu);
  Bench3 bench(plane_far_below(), material, steps());
  const auto endless = [](const Vec3& at, const Rotation3& turn) {
    Body<3> body = make_body({Contactor3::half_space()}, 0, 0);
    body.kind = BodyKind::driven;
    body.x = at;
    body.attitude = turn;
    return body;
  };
  bench.add(endless(Vec3::Zero(), Rotation3::from_vector({0, slope, 0})));
  Body<3> lift = endless({0, 100, 0}, Rotation3::from_vector({0.5 * pi, 0, 0}));  // its normal is -y
  lift.v = {0, -rate, 0};
  bench.add(lift);
  const Vec3 normal(std::sin(slope), 0, std::cos(slope)), way(std::cos(slope), 0, -std::sin(slope));
  const int sliding = bench.add(box({0.4, 0.3, 0.2}, 3, 0.1 * normal, way, normal));
  const int pushed = bench.add(sphere(0.2, 3, {50, 99.8, -5}));
  const Vec3 start = bench.world.bodies[sliding].x, from = bench.world.bodies[pushed].x;
  bench.run(0.5);
  const double a = gravity * (std::sin(slope) - mu * std::cos(slope));
  CHECK((bench.world.bodies[sliding].x - start - 0.125 * a * way).norm() < 1e-6);
  CHECK(bench.world.bodies[pushed].x.y() == Approx(from.y() - 0.5 * rate).margin(1e-6));
  CHECK(bench.world.quality().max_penetration < 1e-7);
}

}  // namespace room_test
