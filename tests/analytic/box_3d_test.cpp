// A box in space: slide, stick, stand, topple, spin.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "geometry/ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace box_3d_test {

namespace {
const double g = 9.81;
}

TEST_CASE("a box on level ground slides with v0 - mu g t in a straight line") {
  const double mu = 0.3, azimuth = GENERATE(0.0, 0.6);
  Material material(0, mu);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  settings.max_iterations = 100000;
  Bench3 bench(plane(), material, settings);
  const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0);
  const int body = bench.add(box({1, 0.8, 0.5}, 1000, {0, 0, 0.25}));
  bench.world.bodies[body].v = 5 * way;
  const BodyHistory& history = bench.run(1);
  CHECK((history.last.velocity - (5 - mu * g) * way).norm() < 1e-12);
  CHECK((history.last.position - (5 - 0.5 * mu * g) * way - Vec3(0, 0, 0.25)).norm() < mu * g * 1e-6 / 8);
  CHECK(history.last.spin.norm() < 1e-12);
}

TEST_CASE("a box on an incline slides with g (sin - mu cos) or sticks") {
  const double slope = 20 * pi / 180, azimuth = 0.3, mu = GENERATE(0.2, 0.5);
  Material material(0, mu);
  WorldSettings settings;
  settings.tolerance = 1e-8;
  settings.max_iterations = 100000;
  Bench3 bench(plane(slope, azimuth), material, settings);
  const Vec3 up = bench.terrain.ground().facet(0).normal, way = down(slope, azimuth);
  bench.add(box({1, 0.8, 0.5}, 1000, 0.25 * up, way, up));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(2);
  if (mu > std::tan(slope)) {
    CHECK((history.last.position - history.first.position).norm() / 2 < 1e-9);  // creep, m/s
  } else {
    const double a = g * (std::sin(slope) - mu * std::cos(slope));
    CHECK((history.last.velocity - 2 * a * way).norm() < 1e-7);
    CHECK((history.last.position - history.first.position - 2 * a * way).norm() < 1e-7);
  }
  CHECK(bench.world.quality().not_converged == 0);
}

TEST_CASE("a box stands on four corners that carry m g h together") {
  Material material(0, 0.5);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  settings.max_iterations = 100000;
  Bench3 bench(plane(), material, settings);
  bench.add(box({1, 0.8, 0.5}, 1000, {0, 0, 0.25}));
  for (int i = 0; i < 10; ++i) bench.world.step(1e-3, true);
  double sum = 0;
  REQUIRE(bench.world.contacts().size() == 4);
  for (const auto& contact : bench.world.contacts()) sum += contact.impulse[0];
  CHECK(sum == Approx(1000 * g * 1e-3).epsilon(1e-9));
}

TEST_CASE(
    "a box that spins on its square base is stopped by the friction of its corners and by spinning "
    "resistance") {
  const double side = 0.4, mass = 20, mu = 0.3, mu_spin = GENERATE(0.0, 0.05), spin = 10;
  Material material(0, mu, 0, 0, mu_spin);
  Bench3 bench(plane(), material);
  bench.add(box({side, side, 0.2}, mass, {0, 0, 0.1}));
  bench.world.bodies[0].w = {0, 0, spin};
  bench.run_settings.stop_speed = 0;
  // However the corners share the weight: I w' = -m g (mu side/sqrt 2 + mu_spin), I = m side^2/6.
  const double slowing = 6 * g / (side * side) * (mu * side / std::sqrt(2.0) + mu_spin);
  CHECK(bench.run(0.5 * spin / slowing).last.spin.z() == Approx(spin / 2).epsilon(1e-4));
  const BodyState rest = bench.run(spin / slowing + 0.002).last;
  CHECK(rest.spin.norm() < 1e-6);
  CHECK(rest.position.head<2>().norm() < 1e-3);
}

TEST_CASE("a box on an incline topples where b/h is less than tan, and slides where mu is") {
  const double slope = std::atan(0.5), azimuth = 0.8;
  const double ratio = GENERATE(0.495, 0.505);  // b/h: the line of gravity leaves the base at 0.5
  Material material(0, 0.7);
  Bench3 bench(plane(slope, azimuth), material);
  const Vec3 up = bench.terrain.ground().facet(0).normal;
  bench.add(box({ratio, 1, 1}, 1000, 0.5 * up, down(slope, azimuth), up));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(1);
  if (ratio > 0.5)
    CHECK(history.last.spin.norm() < 1e-6);
  else
    CHECK(history.last.spin.norm() > 1e-2);
}

TEST_CASE("a free box keeps its energy and angular momentum through a flight in a world") {
  Material material(0, 0);
  Bench3 bench(plane(), material);
  Body<3> body = box({1, 0.6, 0.4}, 1000, {0, 0, 50}, Vec3(0.6, 0.8, 0));
  body.v = {3, -2, 20};
  body.w = {0.05, 6, 0.3};
  const auto momentum = [](const Body<3>& b) {
    const Rotation3& r = b.attitude.rotation;
    return Vec3(r * Vec3(b.inertia.cwiseProduct(r.inverse(b.w))));
  };
  const Vec3 before = momentum(body);
  bench.add(body);
  const double energy = bench.world.total_energy();
  bench.run(4);
  const Body<3>& after = bench.world.bodies[0];
  CHECK((momentum(after) - before).norm() < 1e-10 * before.norm());
  CHECK(bench.world.total_energy() == Approx(energy).epsilon(1e-12));
}

TEST_CASE("the gyroscopic term of a step keeps the energy and |L| at theta 1/2, and loses energy above") {
  const double theta = GENERATE(0.5, 0.8);
  Body<3> body = box({1, 0.6, 0.4}, 1000, {0, 0, 0});
  body.w = {0.5, 8, 1};
  const Vec3 before = body.inertia.cwiseProduct(body.attitude.rotation.inverse(body.w));
  const double energy = body.kinetic_energy();
  for (int i = 0; i < 1000; ++i) {
    body.attitude = body.attitude.turned((1 - theta) * 1e-3 * body.w);
    body.w = free_spin(body, 1e-3, theta, Vec3::Zero());
    body.attitude = body.attitude.turned(theta * 1e-3 * body.w);
  }
  const Vec3 after = body.inertia.cwiseProduct(body.attitude.rotation.inverse(body.w));
  if (theta == 0.5) {
    CHECK(after.norm() == Approx(before.norm()).epsilon(1e-12));
    CHECK(body.kinetic_energy() == Approx(energy).epsilon(1e-12));
  } else {
    CHECK(body.kinetic_energy() < energy);
  }
}

TEST_CASE("the energy of a box that tumbles and slides never grows") {
  Material material(0, 0.4);
  Bench3 bench(plane(0.2), material);
  Body<3> body = box({1, 0.6, 0.4}, 1000, {0, 0, 1.2}, Vec3(0.6, 0, -0.8), Vec3(0.8, 0, 0.6));
  body.v = {4, 1, 0};
  body.w = {2, 5, 1};
  bench.add(body);
  double energy = bench.world.total_energy();
  const double scale = energy;
  for (int i = 0; i < 3000; ++i) {
    bench.world.step(1e-3, false);
    const double now = bench.world.total_energy();
    REQUIRE(now <= energy + 1e-6 * scale);
    energy = now;
  }
  CHECK(bench.world.quality().not_converged == 0);
}

}  // namespace box_3d_test

TEST_CASE("an impulse of contacts in a last, much shorter step is not taken for a torque that goes on") {
  const Vec3 w(25, 14, -2.5), great(2000, -2000, 2000), small(5, 5, 5);  // rad/s
  CHECK_FALSE(goes_on(great, w, 5e-5, 5e-7));
  CHECK(goes_on(great, w, 5e-5, 5e-5));
  CHECK(goes_on(small, w, 5e-5, 5e-7));
  CHECK(goes_on(small, Vec3(0, 0, 0), 5e-5, 5e-7));  // from rest: no notable angle
}
