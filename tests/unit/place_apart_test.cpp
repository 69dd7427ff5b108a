// Rocks that meet each other are placed apart.
#include <catch2/catch.hpp>

#include "batch/load.h"
#include "batch/trial.h"

using namespace flyrock;

TEST_CASE("rocks released at random into one place start apart, and come to rest") {
  Diagnostics diagnostics;
  auto loaded = load_scenario(FLYROCK_SOURCE_DIR "/tests/unit/pit.yaml", {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(loaded);
  TrialRunner runner(loaded->plan.points.front());
  TrialRecords records;
  runner.run(0, records);
  REQUIRE(records.rocks.size() == 12);
  for (const RockRecord& rock : records.rocks) CHECK(rock.reason == StopReason::stopped);
  CHECK(records.totals.quality.max_penetration < 1e-4);
}
