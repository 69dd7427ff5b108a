// A ball in space: bounces, oblique impacts, rolling, spinning.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "geometry/ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace sphere_3d_test {

namespace {
const double g = 9.81;
}

TEST_CASE("a ball that bounces in space rises to e^2n of its height and stops after the total time") {
  const double e = GENERATE(0.5, 0.9);
  Material material(e, 0);
  WorldSettings settings;
  settings.rest_speed = 1e-9;
  Bench3 bench(plane(), material, settings);
  bench.add(sphere(0.1, 1, {0, 0, 1.1}));
  const BodyHistory& ball = bench.run(20);
  double height = 1;
  REQUIRE(ball.apexes.size() > 5);
  for (std::size_t n = 0; n < ball.apexes.size() && height > 1e-6; ++n) {
    height *= e * e;
    CHECK(ball.apexes[n].height == Approx(height).epsilon(1e-9).margin(1e-14));
  }
  CHECK(ball.stop_time == Approx(std::sqrt(2 / g) * (1 + e) / (1 - e)).epsilon(1e-9));
  CHECK(ball.reason == StopReason::stopped);
}

TEST_CASE("an oblique impact of a sphere sticks or slips in the direction of its way") {
  const double mu = GENERATE(0.2, 0.3);
  const double azimuth = GENERATE(0.0, 0.7, 2.5);
  Material material(0.5, mu);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  Bench3 bench(plane(), material, settings);
  const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0), axle(-std::sin(azimuth), std::cos(azimuth), 0);
  bench.add(sphere(1, 1, {0, 0, 1}, 3 * way - 2 * Vec3::UnitZ()));
  bench.world.impact();
  const Body<3>& body = bench.world.bodies[0];
  const bool sticks = mu > 2 * 3 / (7 * 1.5 * 2);
  const double pt = sticks ? 6.0 / 7 : mu * 3;
  CHECK((body.v - ((3 - pt) * way + Vec3::UnitZ())).norm() < 1e-10);
  CHECK((body.w - 2.5 * pt * axle).norm() < 1e-10);
  const Impact& impact = bench.world.impacts().at(0);
  CHECK(impact.pn == Approx(3).epsilon(1e-10));
  CHECK(impact.pt == Approx(pt).epsilon(1e-10));
  CHECK(impact.vt_before == Approx(3).epsilon(1e-10));
  CHECK(impact.energy_change == Approx(sticks ? -2.785714285714286 : -2.67).epsilon(1e-10));
}

TEST_CASE("a sphere on an incline rolls with 5/7 g sin, or slips") {
  const double slope = 30 * pi / 180, azimuth = 0.4, mu = GENERATE(0.1, 0.3), radius = 0.5;
  Material material(0, mu);
  Bench3 bench(plane(slope, azimuth), material);
  bench.add(sphere(radius, 1000, radius * bench.terrain.ground().facet(0).normal));
  const BodyHistory& history = bench.run(2);
  const bool rolls = mu >= 2 * std::tan(slope) / 7;
  const double a = rolls ? 5 * g * std::sin(slope) / 7 : g * (std::sin(slope) - mu * std::cos(slope));
  const double alpha = rolls ? a / radius : 5 * mu * g * std::cos(slope) / (2 * radius);
  const Vec3 way = down(slope, azimuth), axle = bench.terrain.ground().facet(0).normal.cross(way);
  CHECK((history.last.position - history.first.position - 2 * a * way).norm() < 1e-6);
  CHECK((history.last.spin - 2 * alpha * axle).norm() < 1e-6);
}

TEST_CASE("a sliding sphere comes to roll at 5/7 of its speed, one with backspin at (5 v - 2 R w) / 7") {
  const double backspin = GENERATE(0.0, 10.0, 40.0);
  const double radius = 0.5, mu = 0.3, v0 = 3;
  Material material(0, mu);
  Bench3 bench(plane(), material);
  bench.add(sphere(radius, 1000, {0, 0, radius}, {v0, 0, 0}, {0, -backspin, 0}));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(6);
  const double final_speed = (5 * v0 - 2 * radius * backspin) / 7;
  CHECK(history.last.velocity.x() == Approx(final_speed).margin(1e-6));
  CHECK(history.last.spin.y() == Approx(final_speed / radius).margin(1e-6));
  const double slip = 2 * (v0 + radius * backspin) / (7 * mu * g);
  const double x = v0 * slip - 0.5 * mu * g * slip * slip + final_speed * (6 - slip);
  CHECK(history.last.position.x() == Approx(x).margin(1e-5));
}

TEST_CASE("the place where a sliding sphere comes to roll has an error of second order in the step") {
  const double v0 = 3, mu = 0.3, rolls_at = 12 * v0 * v0 / (49 * mu * g), slip = 2 * v0 / (7 * mu * g);
  for (const double h : {8e-3, 4e-3, 2e-3, 1e-3}) {
    Material material(0, mu);
    WorldSettings settings;
    settings.time_step = h;
    settings.tolerance = 1e-12;
    Bench3 bench(plane(), material, settings);
    bench.add(sphere(0.5, 1000, {0, 0, 0.5}, {v0, 0, 0}));
    const BodyHistory& history = bench.run(1);
    // The transition falls anywhere in a step: an error of at most 7/2 mu g h^2 / 8.
    CHECK(std::abs(history.last.position.x() - (rolls_at + 5 * v0 / 7 * (1 - slip))) <=
          3.5 * mu * g * h * h / 8);
  }
}

TEST_CASE("the slip of a sphere turns downhill on an incline: exact velocity, first order in place") {
  const double slope = std::asin(7.0 / 25), azimuth = 0.7, mu = 0.3, radius = 0.35, end = 1;
  const Vec3 way = down(slope, azimuth), normal = plane(slope, azimuth).normal, across = normal.cross(way);
  const double pull = g * std::sin(slope), k = 3.5 * mu / std::tan(slope);
  const Vec3 start = 3 * across, slip = 3.5 * way + 3 * across;
  // |u| = c q^k/sin(phi) with q = tan(phi/2), phi from the downhill direction; docs/course/rolling.md
  const double q = std::tan(std::atan2(3, 3.5) / 2), c = 3 / std::pow(q, k);
  const double slipped_down =
      c * c / (4 * pull) * (std::pow(q, 2 * k - 2) / (2 * k - 2) - std::pow(q, 2 * k + 2) / (2 * k + 2));
  const double slipped_across =
      c * c / (2 * pull) * (std::pow(q, 2 * k - 1) / (2 * k - 1) + std::pow(q, 2 * k + 1) / (2 * k + 1));
  const Vec3 rolling = start - 2.0 / 7 * slip;
  const Vec3 moved = end * rolling + 5.0 / 14 * pull * end * end * way +
                     2.0 / 7 * (slipped_down * way + slipped_across * across);
  double before = 0;
  for (const double h : {4e-3, 2e-3, 1e-3}) {
    Material material(0, mu);
    WorldSettings settings;
    settings.time_step = h;
    Bench3 bench(plane(slope, azimuth), material, settings);
    bench.add(sphere(radius, 10, radius * normal, start, -10 * across));
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(end);
    const Vec3 velocity = rolling + 5.0 / 7 * pull * end * way;
    CHECK((history.last.velocity - velocity).norm() < 1e-10);
    CHECK((history.last.spin - normal.cross(velocity) / radius).norm() < 1e-10);
    const double error = (history.last.position - history.first.position - moved).norm();
    CHECK(error < 0.08 * h);
    if (before > 0) CHECK(error / before == Approx(0.5).margin(0.02));
    before = error;
  }
}

TEST_CASE("rolling resistance stops a sphere with 5 mu_r g / (7 R), and holds it on a slope up to mu_r / R") {
  const double radius = 0.5, mu_r = 0.05, azimuth = 1.1;
  Material material(0, 0.6, mu_r);
  SECTION("deceleration") {
    Bench3 bench(plane(), material);
    const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0);
    bench.add(sphere(radius, 1000, {0, 0, radius}, 3 * way, 6 * Vec3::UnitZ().cross(way)));
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(2);
    CHECK((history.last.velocity - (3 - 2 * 5 * mu_r * g / (7 * radius)) * way).norm() < 1e-6);
  }
  SECTION("slope") {
    const double slope = GENERATE(0.098, 0.102);
    Bench3 bench(plane(slope, azimuth), material);
    bench.add(sphere(radius, 1000, radius * bench.terrain.ground().facet(0).normal));
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(2);
    if (std::tan(slope) < mu_r / radius)
      CHECK(history.last.velocity.norm() < 1e-8);
    else
      CHECK(history.last.velocity.head<2>().norm() > 1e-3);
  }
}

TEST_CASE("spinning resistance stops a sphere on its place after 2 R^2 w / (5 mu_spin g)") {
  const double radius = 0.3, mu_spin = 0.02, spin = 20;
  Material material(0, 0.5, 0, 0, mu_spin);
  Bench3 bench(plane(), material);
  bench.add(sphere(radius, 50, {0, 0, radius}, Vec3::Zero(), {0, 0, spin}));
  bench.run_settings.stop_speed = 0;
  const double stop = 2 * radius * radius * spin / (5 * mu_spin * g);
  const double half = bench.run(0.5 * stop).last.spin.z();
  CHECK(half == Approx(spin / 2).epsilon(1e-9));
  const BodyState rest = bench.run(stop + 0.002).last;
  CHECK(rest.spin.norm() < 1e-9);
  CHECK(rest.position.head<2>().norm() < 1e-12);
}

TEST_CASE("a sphere that rolls and pivots loses both spins by their own torques, on a slope too") {
  // v' = 5/7 (g_t - mu_r g_n / R) along its way and w_n' = -5 mu_spin g_n / (2 R^2), each as if alone
  const double azimuth = GENERATE(0.0, 1.1), slope = GENERATE(0.0, 0.05), share = GENERATE(0.1, 0.4, 1.0);
  const double radius = 0.4, mu_r = 0.06, mu_spin = share * mu_r, pivot = 25, speed = 3, end = 0.6;
  Material material(0, 0.6, mu_r, 0, mu_spin);
  Bench3 bench(plane(slope, azimuth), material);
  const Vec3 normal = bench.terrain.ground().facet(0).normal, way = down(slope, azimuth);
  bench.add(
      sphere(radius, 700, radius * normal, speed * way, normal.cross(way) * speed / radius + pivot * normal));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(end);
  const double rolls = speed + end * 5.0 / 7 * g * (std::sin(slope) - std::cos(slope) * mu_r / radius);
  const double pivots = pivot - end * 5 * mu_spin * g * std::cos(slope) / (2 * radius * radius);
  CHECK((history.last.velocity - rolls * way).norm() < 1e-6);
  CHECK(history.last.spin.dot(normal) == Approx(pivots).epsilon(1e-8));
}

}  // namespace sphere_3d_test
