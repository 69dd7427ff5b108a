// Where rocks start: those that meet each other apart, those of space above the ground or inside a polygon.
#include <catch2/catch.hpp>

#include "load.h"
#include "trial/build_trial.h"

using namespace flyrock;

TEST_CASE("rocks released at random into one place start apart, and come to rest") {
  const TrialRecords records = first_trial(loaded("tests/unit/trial/pit.yaml"));
  REQUIRE(records.rocks.size() == 12);
  for (const RockRecord& rock : records.rocks) CHECK(rock.reason == StopReason::stopped);
  // A step passes over new touches of pairs that are in contact; a quarter of what step_tolerance allows in
  // place.
  CHECK(records.totals.quality.max_penetration < 2.5e-4);
}

TEST_CASE("rocks of space start above the ground, or uniformly inside a flat polygon") {
  const LoadedScenario scenario = loaded("tests/unit/trial/releases_3d.yaml");
  TrialBuilder<3> builder(scenario.plan.points.front());
  constexpr int trials = 2000;
  Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
  for (int k = 0; k < trials; ++k) {
    const auto trial = builder.build(k);
    REQUIRE(trial.worlds.size() == 2);
    const Vec3 above = trial.worlds[0].bodies[0].x, over = trial.worlds[1].bodies[0].x;
    CHECK((above.x() >= 1 && above.x() <= 3 && above.y() == -4));
    CHECK(above.z() == Approx(2 - above.x() / 2).epsilon(1e-12));  // the plane falls by 1 in 2
    CHECK(over.z() == Approx(10 + over.y() / 2).epsilon(1e-12));
    sum += over;
    squares += over.cwiseAbs2();
  }
  // A rectangle of 2 by 4 in plan: means within four standard errors, variances a^2/12.
  const Vec3 mean = sum / trials, variance = squares / trials - mean.cwiseAbs2();
  CHECK(mean.x() == Approx(1).margin(4 * 2 / std::sqrt(12.0 * trials)));
  CHECK(mean.y() == Approx(2).margin(4 * 4 / std::sqrt(12.0 * trials)));
  CHECK(variance.x() == Approx(4 / 12.0).epsilon(0.1));
  CHECK(variance.y() == Approx(16 / 12.0).epsilon(0.1));
}
