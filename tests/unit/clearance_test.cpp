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

TEST_CASE("a clearance by azimuth: quantiles of each sector, and of too few rocks the farthest alone") {
  // Due +y 1000 rocks at 1 to 1000 m from (10, 20); due -x ten rocks, one of which was cut short.
  TrialRecords records;
  const auto add = [&](double x, double y, bool censored) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = records.rocks.size() - 1;
    rock.reason = censored ? StopReason::timed_out : StopReason::stopped;
    rock.censored = censored;
    rock.stop_x = x;
    rock.stop_y = y;
  };
  for (int i = 1; i <= 1000; ++i) add(10, 20 + i, false);
  for (int i = 1; i <= 10; ++i) add(10 - i, 20.001, i == 10);
  ClearancePlan plan;
  plan.probability = 0.05;
  plan.factor = 2;
  plan.sectors = 5;  // 72 degrees each: +y in the second, -x in the third
  plan.x = 10;
  plan.y = 20;
  ClearanceTally tally({plan});
  do tally.see(records);
  while (tally.again());
  const auto sectors = tally.summaries()[0].sectors;
  REQUIRE(sectors.size() == 5);
  CHECK(sectors[1].azimuth == Approx(108 * pi / 180));
  CHECK(sectors[1].count == 1000);
  CHECK(sectors[1].distance.value == Approx(950.05));
  CHECK(sectors[1].with_factor == 2 * sectors[1].distance.value);
  CHECK(sectors[1].greatest.value == 1000);
  CHECK(sectors[2].count == 10);
  CHECK(sectors[2].greatest.value == Approx(10));
  CHECK(sectors[2].greatest.censored);
  CHECK(std::isnan(sectors[2].distance.value));
  CHECK(sectors[2].with_factor == 2 * sectors[2].greatest.value);
  CHECK(sectors[0].count == 0);
  CHECK(std::isnan(sectors[0].greatest.value));
  CHECK(std::isnan(sectors[0].with_factor));
}
