// The bouncing ball: apex n = e^(2n) H, total time sqrt(2H/g) (1 + e)/(1 - e).
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a bouncing ball rises to e^2n of its height and stops after the total time") {
  const double e = GENERATE(0.5, 0.9);
  Material material(e, 0);
  WorldSettings settings;
  settings.rest_speed = 1e-9;
  Bench bench(ground(10), material, settings);
  bench.add(disk(0.1, 1, {0, 1.1}));
  const BodyHistory& ball = bench.run(20);

  double height = 1;
  REQUIRE(ball.apexes.size() > 5);
  for (std::size_t n = 0; n < ball.apexes.size() && height > 1e-6; ++n) {
    height *= e * e;
    CHECK(ball.apexes[n].height == Approx(height).epsilon(1e-9));
  }
  CHECK(ball.stop_time == Approx(std::sqrt(2 / 9.81) * (1 + e) / (1 - e)).epsilon(1e-9));
  CHECK(ball.reason == StopReason::stopped);
  CHECK(bench.world.quality().not_converged == 0);
}

TEST_CASE("with the default rest speed the lost time is 2 v / (g (1 - e))") {
  const double e = 0.9;
  Material material(e, 0);
  Bench bench(ground(10), material);
  bench.add(disk(0.1, 1, {0, 1.1}));
  const BodyHistory& ball = bench.run(20);
  // The first approach below rest_speed is not restituted: the remaining bounces are lost.
  const double v = ball.impacts.back().vn_after * e;
  const double lost =
      2 * ball.impacts.back().vn_after / (9.81 * (1 - e)) - 2 * ball.impacts.back().vn_after / 9.81;
  CHECK(v < 0.02);
  CHECK(ball.stop_time == Approx(std::sqrt(2 / 9.81) * (1 + e) / (1 - e) - lost).margin(1e-9));
}
