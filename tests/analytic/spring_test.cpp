// Springs and dampers in place of constraints (`penalty`), at chosen steps and at short fixed ones.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

struct Penalty : UnilateralLaw {
  Spring spring;
  explicit Penalty(const Spring& s) : spring(s) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "penalty"; }
  Unilateral condition(Values, const ContactState&) const override {
    return {NormalCondition::penalty, spring, 0};
  }
};

/// A material whose constraint is a spring.
struct Springs : Material {
  Penalty penalty;
  Springs(const Spring& spring, double mu, double mu_r = 0) : Material(0.5, mu, mu_r), penalty(spring) {
    surface.unilateral.law = &penalty;
  }
};

WorldSettings chosen() {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  return settings;
}
WorldSettings fixed(double h) {
  WorldSettings settings;
  settings.time_step = h;
  return settings;
}

constexpr double mass = 2, stiffness = 1e5, radius = 0.1;
constexpr double settling = 0.5;  // s, until a damped ball lies still on its spring
// Of the contact at rest, in radii: forces act in the middle of the overlap.
const double lever = 1 - 0.5 * mass * 9.81 / stiffness / radius;
const double omega = std::sqrt(stiffness / mass);

/// The share of its speed that a ball of 3 m/s keeps.
double bounce(const Spring& spring, const WorldSettings& settings) {
  Springs material(spring, 0);
  Bench bench(ground(1), material, settings, {0, 0});
  const int ball = bench.add(disk(radius, mass, {0, radius + 0.01}, {0, -3}));
  bench.run(0.2);
  CHECK(bench.world.quality().energy_gains == 0);
  return bench.world.bodies[ball].v.y() / 3;
}

}  // namespace

TEST_CASE("a damper takes its closed-form share of a bounce, whatever the restitution of the material") {
  for (const double z : {0.0, 0.05, 0.2, 0.6}) {
    // The contact ends when its force is zero, before the overlap is.
    const double root = std::sqrt(1 - z * z), phase = pi - std::atan2(2 * z * root, 1 - 2 * z * z);
    const double kept = std::exp(-z / root * phase);
    const Spring spring{.stiffness = stiffness, .damping = 2 * z * std::sqrt(stiffness * mass)};
    INFO("z " << z);
    CHECK(bounce(spring, chosen()) == Approx(kept).epsilon(2e-3));
    CHECK(bounce(spring, fixed(0.01 / omega)) == Approx(kept).epsilon(2e-5));
  }
}

TEST_CASE("a spring that has opened has no energy, also where the body has left its features far behind") {
  Springs material({.stiffness = 1e7}, 0);
  Profile ledge;
  ledge.points = {{-10, 0}, {1, 0}, {2, -20}, {60, -20}};
  ledge.part = {0, 0, 0};
  ledge.parts = {""};
  Bench bench(ledge, material, chosen());
  const int ball = bench.add(disk(0.2, 100, {0, 0.3}, {6, 0}));
  bench.run(1);  // it has bounced before the crest and is now in the air, below the line of the ledge
  const Body<2>& body = bench.world.bodies[ball];
  REQUIRE(body.x.y() < 0);
  CHECK(bench.world.total_energy() == Approx(body.kinetic_energy() + body.mass * 9.81 * body.x.y()));
}

TEST_CASE("a spring of Hertz turns a ball round at its closed-form overlap and gives its speed back") {
  const double k = 1e7, v = 3, deepest = std::pow(5 * mass * v * v / (4 * k), 0.4);
  for (const WorldSettings& settings : {chosen(), fixed(1e-6)}) {
    Springs material({.stiffness = k, .exponent = 1.5}, 0);
    Bench bench(ground(1), material, settings, {0, 0});
    const int ball = bench.add(disk(radius, mass, {0, radius + 0.01}, {0, -v}));
    bench.run(0.2);
    CHECK(bench.world.quality().max_penetration == Approx(deepest).epsilon(5e-3));
    CHECK(bench.world.bodies[ball].v.y() == Approx(v).epsilon(1e-3));
  }
}

TEST_CASE("the dampers of two contacts act together: a box sinks as m x'' + 2 c x' + 2 k x = m g") {
  const double c = 80, slow = c / mass, quick = std::sqrt(2 * stiffness / mass - slow * slow);
  const double rest = mass * 9.81 / (2 * stiffness);
  Springs material({.stiffness = stiffness, .damping = c}, 0.3);
  Bench bench(ground(2), material, fixed(2e-5));
  const int block = bench.add(box(1, 0.4, mass, {0, 0.2}));
  bench.run_settings.stop_speed = 0;
  for (const double t : {0.004, 0.01, 0.03}) {
    const BodyHistory& history = bench.run(t);
    const double sunk =
        rest * (1 - std::exp(-slow * t) * (std::cos(quick * t) + slow / quick * std::sin(quick * t)));
    CHECK(0.2 - history.last.position.y() == Approx(sunk).margin(2e-4 * rest));
    CHECK(std::abs(bench.world.bodies[block].w) < 1e-12);
  }
}

TEST_CASE("a ball on a strong damper sinks and creeps by two exponentials, in steps of the slow one") {
  // m d'' = m g - k d - c d', with 2 c = 100 sqrt(k m): the quick part decays within 0.1 ms.
  constexpr double z = 50, speed = 0.05, end = 0.05;
  const double root = std::sqrt(z * z - 1), quick = omega * (z + root), slow = omega / (z + root);
  const double rest = mass * 9.81 / stiffness, by_slow = (speed - quick * rest) / (quick - slow);
  const auto overlap = [&](double t) {
    return rest + by_slow * std::exp(-slow * t) - (rest + by_slow) * std::exp(-quick * t);
  };
  Springs material({.stiffness = stiffness, .damping = 2 * z * std::sqrt(stiffness * mass)}, 0);
  Bench bench(ground(1), material, chosen());
  bench.add(disk(radius, mass, {0, radius}, {0, -speed}));
  bench.run_settings.stop_speed = 0;
  for (const double t : {1e-4, 5e-3, end}) {
    const BodyHistory& history = bench.run(t);
    CHECK(radius - history.last.position.y() == Approx(overlap(t)).margin(0.01 * rest));
  }
  CHECK(bench.world.quality().steps < 400);  // with 40 steps in each period of the damper, 7000
}

TEST_CASE("a tangential spring swings a disk that touches: v_t = v_t(0) cos(sqrt(k_t W_tt) t)") {
  const double k_t = 2e4, w = 1 + 2 * lever * lever, swing = std::sqrt(w * k_t / mass), slip = 0.01;
  for (const bool chooses : {true, false}) {
    Springs material({.stiffness = stiffness, .damping = 500, .tangential_stiffness = k_t}, 10);
    Bench bench(ground(2), material, chooses ? chosen() : fixed(1e-5));
    const int ball = bench.add(disk(radius, mass, {0, radius}));
    bench.run_settings.stop_speed = 0;
    bench.run(settling);
    bench.world.bodies[ball].v.x() = slip;
    for (const double t : {0.25, 0.5, 0.8, 3.5}) {
      bench.run(settling + t * 2 * pi / swing);
      const double expected = slip - slip / w * (1 - std::cos(t * 2 * pi));
      INFO("t " << t << ", chosen steps " << chooses);
      CHECK(bench.world.bodies[ball].v.x() == Approx(expected).margin((chooses ? 2e-2 : 2e-5) * slip));
    }
  }
}

TEST_CASE("a tangential spring slides at mu F, and holds a block on an incline without creep") {
  const Spring spring{.stiffness = 1e6, .damping = 400, .tangential_stiffness = 5e5};
  SECTION("slides") {
    const double slope = 0.5, mu = 0.3;
    Springs material(spring, mu);
    Bench bench(ground(20, slope), material, chosen());
    bench.run_settings.stop_speed = 0;
    const Vec2 up(std::sin(slope), std::cos(slope)), along(up.y(), -up.x());
    bench.add(box(1, 0.2, mass, 0.1 * up, -slope));
    const double early = bench.run(1).last.velocity.head<2>().dot(along);
    const double late = bench.run(2).last.velocity.head<2>().dot(along);
    CHECK(late - early == Approx(9.81 * (std::sin(slope) - mu * std::cos(slope))).epsilon(1e-4));
  }
  SECTION("holds") {
    const double slope = 0.5, mu = 0.7;
    Springs material(spring, mu);
    Bench bench(ground(20, slope), material, chosen());
    bench.run_settings.stop_speed = 0;
    const Vec2 up(std::sin(slope), std::cos(slope)), along(up.y(), -up.x());
    bench.add(box(1, 0.2, mass, 0.1 * up, -slope));
    const Vec3 settled = bench.run(3).last.position, later = bench.run(13).last.position;
    CHECK((later - settled).norm() < 1e-8);
    const double stretch = mass * 9.81 * std::sin(slope) / (2 * spring.tangential_stiffness);
    CHECK(later.head<2>().dot(along) > 0.5 * stretch);
    CHECK(later.head<2>().dot(along) < 5 * stretch);
  }
}

TEST_CASE("in 3D a sphere bounces and swings on springs as a disk does") {
  const double z = 0.2, root = std::sqrt(1 - z * z), phase = pi - std::atan2(2 * z * root, 1 - 2 * z * z);
  Springs damped({.stiffness = stiffness, .damping = 2 * z * std::sqrt(stiffness * mass)}, 0);
  Bench3 drop(plane(), damped, chosen(), {0, 0, 0});
  const int ball = drop.add(sphere(radius, mass, {0, 0, radius + 0.01}, {0, 0, -3}));
  drop.run(0.2);
  CHECK(drop.world.bodies[ball].v.z() == Approx(3 * std::exp(-z / root * phase)).epsilon(2e-3));

  const double k_t = 2e4, w = 1 + 2.5 * lever * lever, swing = std::sqrt(w * k_t / mass), slip = 0.01,
               part = 0.8 * 2 * pi;
  const Vec3 way = Vec3(1, 2, 0).normalized();
  Springs springs({.stiffness = stiffness, .damping = 500, .tangential_stiffness = k_t}, 10);
  Bench3 bench(plane(), springs, fixed(1e-5));
  const int rolling = bench.add(sphere(radius, mass, {0, 0, radius}));
  bench.run_settings.stop_speed = 0;
  bench.run(settling);
  bench.world.bodies[rolling].v += slip * way;
  bench.run(settling + part / swing);
  const double expected = slip - slip / w * (1 - std::cos(part));
  CHECK((bench.world.bodies[rolling].v - expected * way).norm() < 2e-5 * slip);
}

TEST_CASE(
    "a box slides on springs over a hardly convex edge, as deep in the ground as its springs, without "
    "touches") {
  Springs springs({.stiffness = 2e7, .damping = 3000}, 0.4);
  Mesh mesh;
  mesh.vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 2, -1e-7}, {-2, 2, 0}};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
  mesh.part = {0, 0};
  mesh.parts = {""};
  Bench3 bench(mesh, springs, chosen());
  const Vec3 size(0.115, 0.055, 0.031);
  Body<3> body = box(size, 0.5, {-0.2, 0.18, 0.5 * size.z()});
  body.v = {1, 0, 0};
  body.w = {0, 0, -0.35};
  bench.add(body);
  bench.run(0.3);
  CHECK(bench.world.bodies[0].x.x() > -0.1);
  CHECK(bench.world.quality().impact_problems < 100);
}
