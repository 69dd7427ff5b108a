// Rolling of a disk (k = I / m R^2 = 1/2).
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace roll_test {

namespace {
const double g = 9.81;
}

TEST_CASE("a disk on an incline rolls with g sin / (1 + k), or slips") {
  const double slope = 30 * pi / 180, mu = GENERATE(0.1, 0.3);
  Material material(0, mu);
  Bench bench(ground(50, slope), material);
  const Vec2 up(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  bench.add(disk(0.5, 1000, 0.5 * up));
  const BodyHistory& history = bench.run(2);
  const bool rolls = mu >= std::tan(slope) / 3;
  const double a = rolls ? g * std::sin(slope) / 1.5 : g * (std::sin(slope) - mu * std::cos(slope));
  CHECK((history.last.position - history.first.position).head<2>().dot(along) == Approx(2 * a).epsilon(1e-6));
  const double alpha = rolls ? a / 0.5 : mu * g * std::cos(slope) / (0.5 * 0.5);
  CHECK(-history.last.spin.z() == Approx(2 * alpha).epsilon(1e-6));
}

TEST_CASE("a sliding disk comes to roll at 2/3 of its speed, one with backspin at (v - k R w) / (1 + k)") {
  const double backspin = GENERATE(0.0, 10.0, 40.0);  // 40: it returns, R w > v / k
  Material material(0, 0.3);
  Bench bench(ground(50), material);
  bench.add(disk(0.5, 1000, {0, 0.5}, {6, 0}, backspin));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(6);
  const double final_speed = (6 - 0.5 * 0.5 * backspin) / 1.5;
  CHECK(history.last.velocity.x() == Approx(final_speed).margin(1e-6));
  CHECK(history.last.spin.z() == Approx(-final_speed / 0.5).margin(1e-6));
  const double slip_time = (6 + 0.5 * backspin) * 0.5 / 1.5 / (0.3 * g);
  const double x = 6 * slip_time - 0.5 * 0.3 * g * slip_time * slip_time + final_speed * (6 - slip_time);
  CHECK(history.last.position.x() == Approx(x).margin(1e-5));
}

TEST_CASE("rolling resistance stops a disk with 2 mu_r g / (3 R), and holds it on a slope up to mu_r / R") {
  SECTION("deceleration") {
    Material material(0, 0.6, 0.05);
    Bench bench(ground(100), material);
    bench.add(disk(0.5, 1000, {0, 0.5}, {3, 0}, -6));
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(2);
    CHECK(history.last.velocity.x() == Approx(3 - 2 * 2 * 0.05 * g / (3 * 0.5)).epsilon(1e-6));
  }
  SECTION("slope") {
    const double slope = GENERATE(0.098, 0.102);  // mu_r / R = 0.1
    Material material(0, 0.6, 0.05);
    Bench bench(ground(100, slope), material);
    bench.add(disk(0.5, 1000, 0.5 * Vec2(std::sin(slope), std::cos(slope))));
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(2);
    if (std::tan(slope) < 0.1)
      CHECK(history.last.velocity.norm() < 1e-8);
    else
      CHECK(history.last.velocity.x() > 1e-3);
  }
}

TEST_CASE("the place where a sliding disk comes to roll has an error of second order in the step") {
  const auto error = [](double h) {
    Material material(0, 0.3);
    WorldSettings settings;
    settings.time_step = h;
    settings.tolerance = 1e-12;
    Bench bench(ground(50), material, settings);
    bench.add(disk(0.5, 1000, {0, 0.5}, {6, 0}));
    const BodyHistory& history = bench.run(2);
    const double slip = 6 * 0.5 / 1.5 / (0.3 * g);
    return std::abs(history.last.position.x() - (6 * slip - 0.5 * 0.3 * g * slip * slip + 4 * (2 - slip)));
  };
  // The transition falls anywhere in a step, so that the bound is what shrinks: 3 mu g h^2 / 8 at most.
  for (const double h : {8e-3, 4e-3, 2e-3, 1e-3}) CHECK(error(h) <= 3 * 0.3 * g * h * h / 8);
  CHECK(error(1e-3) < 2e-6);
}

}  // namespace roll_test
