// Flights of rigid bodies through air, against closed forms and the reference integration of a sphere of 0.1
// m and 2700 kg/m3 with c_d 1 at 60 m/s and 45 degrees: 197.8927 m, 7.15237 s, apex 63.3257 m.
#include <catch2/catch.hpp>

#include "lab_3d.h"

using namespace flyrock;

namespace {

constexpr double g = 9.81;
const double reference_drag = drag_constant(1.225, 1, 2700 * pi / 6 * 1e-3, pi / 6 * 1e-3);
const double root = std::sqrt(0.5);

Body<2> ball(const Vec2& at, const Vec2& velocity, const Air<2>& air) {
  Body<2> body = lab::disk(0.05, 1.4, at, velocity);
  body.air = air;
  return body;
}

}  // namespace

TEST_CASE("a leg through air has the order of its scheme, and is gravity alone without drag") {
  const Air<2> air{reference_drag, {3, 0}};
  const Vec2 v(40, 30), gravity(0, -g);
  // Velocity at the end of one leg of h against that of many short ones.
  const auto flown = [&](double h, int legs) {
    Vec2 x = Vec2::Zero(), u = v;
    for (int i = 0; i < legs; ++i)
      for (const Vec2& a : leg_accelerations(air, u, gravity, h / legs)) {
        const double t = 0.5 * h / legs;
        x += t * u + 0.5 * t * t * (gravity + a);
        u += t * (gravity + a);
      }
    return std::pair(x, u);
  };
  const auto error = [&](double h) {
    const auto [x, u] = flown(h, 1);
    const auto [exact_x, exact_u] = flown(h, 64);
    return std::pair((x - exact_x).norm(), (u - exact_u).norm());
  };
  const auto [x1, u1] = error(0.8);
  const auto [x2, u2] = error(0.4);
  CHECK(std::log2(u1 / u2) == Approx(5).margin(0.4));  // of one step: an order above that of the scheme
  CHECK(std::log2(x1 / x2) > 4.5);
  for (const Vec2& a : leg_accelerations<2>({0, {3, 0}}, v, gravity, 0.1)) CHECK(a == Vec2::Zero());
  CHECK(leg_length<2>({0, {3, 0}}, v, gravity) == 0.1);
}

TEST_CASE("a rigid body through air lands where the reference integration does, in the plane and in space") {
  lab::Material soft(0, 10);
  lab::Bench bench(lab::ground(500), soft);
  bench.add(ball({0, 0.05}, 60 * Vec2(root, root), {reference_drag, Vec2::Zero()}));
  const BodyHistory& history = bench.run(8);
  CHECK(history.flight_range == Approx(197.8927).epsilon(1e-6));
  CHECK(history.bounce_height == Approx(63.3257 + 0.05).epsilon(1e-6));
  REQUIRE(history.impacts.size() >= 1);
  CHECK(history.impacts[0].time == Approx(7.15237).epsilon(1e-6));
  CHECK(std::hypot(history.impacts[0].vn_before, history.impacts[0].vt_before) ==
        Approx(35.924).epsilon(2e-5));

  lab::Material soft3(0, 10);
  lab::Bench3 space(lab::plane(), soft3);
  Body<3> sphere = lab::sphere(0.05, 1.4, {0, 0, 0.05}, 60 * Vec3(0.6 * root, 0.8 * root, root));
  sphere.air.drag = reference_drag;
  space.add(std::move(sphere));
  CHECK(space.run(8).flight_range == Approx(197.8927).epsilon(1e-6));
}

TEST_CASE("a body without drag flies as if there were no air, to the last bit") {
  lab::Material hard(0.5, 0.3);
  const auto run = [&](const Air<2>& air) {
    lab::Bench bench(lab::ground(500), hard);
    bench.add(ball({0, 1}, {20, 10}, air));
    return bench.run(30);
  };
  const BodyHistory calm = run({}), windy = run({0, {10, 0}});
  CHECK(calm.last.position == windy.last.position);
  CHECK(calm.last.time == windy.last.time);
  CHECK(run({1e-9, Vec2::Zero()}).flight_range ==
        Approx(calm.flight_range).epsilon(1e-6));  // and tends to it
}

TEST_CASE(
    "a block through air lands on a bench where its lowest corner meets it, and fences stop it on the way") {
  Profile profile;
  profile.points = {{-50, 12}, {0, 12}, {4, 0}, {500, 0}};
  profile.part = {0, 0, 0};
  profile.parts = {""};
  lab::Material soft(0, 10);
  const auto falling = [&](double fence) {
    lab::Bench bench(profile, soft);
    Body<2> block = lab::box(0.4, 0.4, 1.4, {0, 12.5}, pi / 4);
    block.v = {12, 3};
    block.air = {0.05, {-4, 0}};
    bench.add(block);
    const Barrier barrier{fence, 100, 1e9};
    if (fence > 0) bench.run_settings.barriers = {&barrier, 1};
    return bench.run(20);
  };
  const BodyHistory landed = falling(0);
  REQUIRE(landed.impacts.size() >= 1);
  const Impact& first = landed.impacts[0];
  CHECK(first.place.y() == Approx(0).margin(1e-6));
  // The same point, flown in small steps: its lowest corner is 0.2 sqrt 2 below it.
  Vec2 x(0, 12.5), v(12, 3);
  const Air<2> air{0.05, {-4, 0}};
  const double h = 1e-5;
  double t = 0, at_fence = 0;
  while (x.y() > 0.4 * root) {
    const Vec2 middle = v + 0.5 * h * (Vec2(0, -g) + air.acceleration(v));
    v += h * (Vec2(0, -g) + air.acceleration(middle));
    x += h * middle;
    t += h;
    if (x.x() < 8) at_fence = t;
  }
  CHECK(first.time == Approx(t).epsilon(1e-5));
  CHECK(first.place.x() == Approx(x.x()).epsilon(1e-5));
  const BodyHistory caught = falling(8);
  CHECK(caught.reason == StopReason::caught);
  CHECK(caught.last.time == Approx(at_fence).epsilon(1e-4));
  CHECK(caught.last.position.x() == Approx(8).epsilon(1e-9));
}

TEST_CASE("drag acts on a body that slides") {
  // Level ground without friction: dv/dt = -k v^2, so that 1/v grows with k t.
  lab::Material ice(0, 0);
  lab::Bench bench(lab::ground(500), ice);
  bench.add(ball({0, 0.05}, {20, 0}, {0.02, Vec2::Zero()}));
  bench.run_settings.stop_speed = 0;
  CHECK(bench.run(2).last.velocity.x() == Approx(1 / (1 / 20.0 + 0.02 * 2)).epsilon(1e-6));
}
