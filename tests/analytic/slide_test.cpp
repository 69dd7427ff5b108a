// Coulomb friction of a block: slide, stop, stick.
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a block on level ground slides v^2 / (2 mu g)") {
  Material material(0, 0.5);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  Bench bench(ground(20), material, settings);
  const int block = bench.add(box(1, 1, 1000, {0, 0.5}));
  bench.world.bodies[block].v = {5, 0};
  SECTION("velocity v0 - mu g t") {
    const BodyHistory& history = bench.run(1);
    CHECK(history.last.velocity.x() == Approx(5 - 0.5 * 9.81).margin(1e-12));
    CHECK(history.last.position.y() == Approx(0.5).margin(1e-12));
    CHECK(std::abs(history.last.spin.z()) < 1e-12);
  }
  SECTION("distance") {
    const BodyHistory& history = bench.run(3);
    const double h = settings.time_step;
    CHECK(history.last.position.x() == Approx(25 / (2 * 0.5 * 9.81)).margin(0.5 * 9.81 * h * h / 8));
    CHECK(history.reason == StopReason::stopped);
  }
}

TEST_CASE("a block on an incline slides with g (sin - mu cos) or sticks") {
  const double slope = 30 * pi / 180;
  const double mu = GENERATE(0.3, 0.7);
  Material material(0, mu);
  WorldSettings settings;
  settings.tolerance = 1e-8;
  Bench bench(ground(50, slope), material, settings);
  const Vec2 up(std::sin(slope), std::cos(slope));
  bench.add(box(1, 1, 1000, 0.5 * up, -slope));
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(2);
  const Vec2 along(std::cos(slope), -std::sin(slope));
  if (mu > std::tan(slope)) {
    CHECK((history.last.position - history.first.position).norm() / 2 < 1e-9);  // creep, m/s
  } else {
    const double a = 9.81 * (std::sin(slope) - mu * std::cos(slope));
    CHECK(history.last.velocity.head<2>().dot(along) == Approx(2 * a).epsilon(1e-8));
    CHECK((history.last.position - history.first.position).head<2>().dot(along) ==
          Approx(2 * a).epsilon(1e-8));
  }
  CHECK(bench.world.quality().not_converged == 0);
}
