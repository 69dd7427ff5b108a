// The safety factor of a clearance.

#include "batch/clearance.h"

#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("a safety factor multiplies the distance once, and nothing else") {
  TrialRecords records;
  for (int i = 0; i < 1000; ++i) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = static_cast<std::uint64_t>(i);
    rock.reason = StopReason::stopped;
    rock.runout = rock.max_distance = i;
    rock.launch_speed = 20;
  }
  ClearancePlan plain;
  plain.name = "zone";
  plain.probability = 0.05;
  ClearancePlan safe = plain;
  safe.factor = 2;
  ClearanceTally tally({plain, safe});
  do tally.see(records);
  while (tally.again());
  const auto summaries = tally.summaries();
  CHECK(summaries[0].distance.value == Approx(949.05));
  CHECK(std::isnan(summaries[0].with_factor));
  CHECK(summaries[1].distance.value == summaries[0].distance.value);
  CHECK(summaries[1].interval.lower == summaries[0].interval.lower);
  CHECK(summaries[1].interval.upper == summaries[0].interval.upper);
  CHECK(summaries[1].with_factor == 2 * summaries[1].distance.value);
}
