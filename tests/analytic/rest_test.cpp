// A body is at rest where it stays, not where it is slow for a moment.
#include "flight/rest.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "analytic/lab_3d.h"
#include "geometry/ground.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a box that slowly passes over its corner comes to rest on its side") {
  // About the corner I = m (1/6 + 1/2) of a square of 1 m. The energy at the tilt a before the top:
  // I w^2 / 2 = I w_top^2 / 2 + m g r (1 - cos a), with r = 1 / sqrt(2).
  const double r = std::sqrt(0.5), inertia = 2.0 / 3;
  for (const double speed_at_top : {0.002, 0.005, 0.01, 0.02, 0.035, 0.045}) {
    for (const double tilt : {0.002, 0.01, 0.03}) {
      INFO(speed_at_top << " m/s at the top, released " << tilt << " rad before it");
      Material rough(0, 2);
      Bench bench(ground(20), rough);
      Body<2> square = box(1, 1, 1000, {-r * std::sin(tilt), r * std::cos(tilt)}, pi / 4 + tilt);
      square.w = -std::sqrt(std::pow(speed_at_top / r, 2) + 2 * 9.81 * r * (1 - std::cos(tilt)) / inertia);
      square.v = -square.w * Vec2(square.x.y(), -square.x.x());
      bench.add(square);
      const BodyHistory& history = bench.run(30);
      CHECK(history.reason == StopReason::stopped);
      CHECK(std::abs(history.last.position.y() - 0.5) < 1e-6);
      CHECK(std::abs(std::remainder(history.last.angle, pi / 2)) < 1e-6);
      CHECK(history.last.position.x() > 0.4);  // on the side beyond the top
    }
  }
}

TEST_CASE("a disk that rolls slowly on level ground counts as at rest after 0.2 s") {
  Material rough(0, 0.5);
  Bench bench(ground(20), rough);
  bench.add(disk(0.5, 1000, {0, 0.5}, {0.03, 0}, -0.06));
  const BodyHistory& history = bench.run(30);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.stop_time == 0);
  CHECK(history.last.time == Approx(rest_time));
}

TEST_CASE(
    "a disk that starts to slide down a slope of half a millimetre a metre does not rest, however slow it "
    "is") {
  Material smooth(0, 0);
  const double slope = 5e-4;
  Bench bench(ground(20, slope), smooth);
  bench.add(disk(0.5, 1000, 0.5 * Vec2(std::sin(slope), std::cos(slope))));
  const BodyHistory& history = bench.run(20);
  CHECK(history.reason == StopReason::timed_out);
  CHECK(history.last.velocity.norm() == Approx(20 * 9.81 * std::sin(slope)));
}

TEST_CASE("a body that rocks slower than the stop speed is at rest after the settling time") {
  BodyHistory history;
  RestWatch watch(RestWatch::Kind::body, 0.05, history);
  const double h = 0.01;
  double time = 0, speed = 0.049;
  for (; std::isnan(history.stop_time); time += h) {
    const double next = 0.049 * std::abs(std::cos(3 * (time + h)));
    watch.rests(time, time + h, Pace::without_pivot(speed), Pace::without_pivot(next), {});
    speed = next;
    REQUIRE(time < 2 * settling_time);
  }
  CHECK(time == Approx(settling_time).margin(2 * h));
}

namespace rest_test {

struct Draw {
  std::mt19937 rng;
  double operator()(double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); }
};

/// A sphere that stands on a slope, held by its rolling resistance, and spins about the normal.
struct PivotingSphere {
  Material material;
  Bench3 bench;
  Vec3 spin;

  PivotingSphere(Draw& uniform, double radius, double mu_spin)
      : material(0, 0.8, 0.2 * radius, 0, mu_spin), bench(plane(uniform(0, 0.15), uniform(0, 6)), material) {
    const Vec3 normal = bench.terrain.ground().facet(0).normal;
    spin = (uniform(0, 1) < 0.5 ? -1 : 1) * uniform(0.2, 50) / radius * normal;
    bench.add(sphere(radius, uniform(1, 5000), radius * normal, Vec3::Zero(), spin));
  }
};

/// Bumps of up to `height` over a valley along y, 40 m long.
HeightGrid rough_valley(Draw& uniform, double height) {
  HeightGrid grid;
  grid.columns = grid.rows = 41;
  grid.corner = {-20, -20};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      grid.heights.push_back(0.4 * std::abs(column - 20) + uniform(0, height));
  return grid;
}

}  // namespace rest_test

TEST_CASE("a sphere that pivots on its place has stopped if nothing slows its spin, and keeps it") {
  rest_test::Draw uniform{std::mt19937(7)};
  for (int i = 0; i < 40; ++i) {
    const double radius = uniform(0.05, 2);
    rest_test::PivotingSphere pivoting(uniform, radius, 0);
    INFO("sphere " << i << ", radius " << radius << " m, spin " << pivoting.spin.norm() << " rad/s");
    const BodyHistory& history = pivoting.bench.run(30);
    CHECK(history.reason == StopReason::stopped);
    CHECK(history.stop_time == 0);
    CHECK(history.last.time == Approx(rest_time));
    CHECK((history.last.spin - pivoting.spin).norm() < 1e-9 * pivoting.spin.norm());
  }
}

TEST_CASE("a sphere whose pivot a torque slows, however little, has not stopped before the pivot has") {
  rest_test::Draw uniform{std::mt19937(8)};
  const double g = 9.81;
  for (const double share : {1e-7, 1e-5, 0.02, 0.1}) {
    const double radius = uniform(0.1, 1), mu_spin = share * radius;
    rest_test::PivotingSphere pivoting(uniform, radius, mu_spin);
    const double tilt = pivoting.bench.terrain.ground().facet(0).normal.z(), spin = pivoting.spin.norm();
    // J w' = -mu_spin r_n until R w is the stop speed
    const double stop = 2 * radius * (radius * spin - 0.05) / (5 * mu_spin * g * tilt);
    INFO("radius " << radius << " m, mu_spin " << mu_spin << " m, spin " << spin << " rad/s");
    const BodyHistory& history = pivoting.bench.run(20);
    if (stop > 20) {
      CHECK(history.reason == StopReason::timed_out);
    } else {
      CHECK(history.reason == StopReason::stopped);
      CHECK(history.stop_time == Approx(stop).epsilon(1e-6));
    }
  }
}

TEST_CASE("a sphere that spins about another direction than the normal slips, and has not stopped") {
  Material smooth(0, 0, 0.01);
  Bench3 bench(plane(), smooth);
  bench.add(sphere(0.3, 100, {0, 0, 0.3}, Vec3::Zero(), {0, 1, 5}));
  bench.run_settings.stop_speed = 0.05;
  CHECK(bench.run(0.25).reason == StopReason::timed_out);
}

TEST_CASE("spheres with rolling resistance come to rest on random ground, whatever resists their pivot") {
  for (int i = 0; i < 15; ++i) {
    rest_test::Draw uniform{std::mt19937(i)};
    const double radius = uniform(0.2, 0.8), mu_r = radius * uniform(0.1, 0.4);
    const double mu_spin = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.4 * mu_r : mu_r;
    INFO("sphere " << i << ": radius " << radius << " m, mu_r " << mu_r << " m, mu_spin " << mu_spin << " m");
    Material material(uniform(0, 0.5), uniform(0.3, 0.9), mu_r, 0, mu_spin);
    Bench3 bench(rest_test::rough_valley(uniform, uniform(0.05, 0.4)), material);
    bench.add(sphere(radius, 1000, {uniform(-12, 12), 0, 8}, {uniform(-3, 3), uniform(-2, 2), 0},
                     {uniform(-9, 9), uniform(-9, 9), uniform(-9, 9)}));
    const BodyHistory& history = bench.run(60);
    CHECK(history.reason == StopReason::stopped);
    CHECK(history.last.velocity.norm() < 0.05);
  }
}
