// The safety factor of a clearance.

#include "results/clearance.h"

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
  do tally.add(records);
  while (tally.needs_another_pass());
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
  plan.about = Vec2(10, 20);
  ClearanceTally tally({plan});
  do tally.add(records);
  while (tally.needs_another_pass());
  const ClearanceSummary found = tally.summaries()[0];
  const auto sectors = found.area.sectors;
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
  CHECK(sectors[1].share.value == Approx(1000.0 / 1010));
  // The farthest of the polygon is what the clearance says; ten rocks of which one was cut short may have
  // gone farther still.
  CHECK(found.distance.value == sectors[1].distance.value);
  CHECK(found.interval.lower == sectors[1].interval.lower);
  CHECK(found.interval.lower < found.distance.value);
  CHECK(found.interval.upper > found.distance.value);
  CHECK(found.with_factor == sectors[1].with_factor);
  CHECK(found.distance.censored);
  // No rock, no data: not a distance of 0.
  CHECK(sectors[0].count == 0);
  CHECK(std::isnan(sectors[0].greatest.value));
  CHECK(std::isnan(sectors[0].with_factor));
}

TEST_CASE("the distances of sectors count from the hull of all release places, azimuths about its centroid") {
  // Released all over a square of 100 m about (1000, 0), and 30 m or 60 m outside of it at rest, due east and
  // due north.
  TrialRecords records;
  for (int i = 0; i <= 20; ++i)
    for (int k = 0; k <= 20; ++k)
      for (const bool east : {true, false}) {
        RockRecord& rock = records.rocks.emplace_back();
        rock.trial = records.rocks.size() - 1;
        rock.group = east ? 0 : 1;
        rock.reason = StopReason::stopped;
        rock.start_x = 950 + 5 * i;
        rock.start_y = -50 + 5 * k;
        rock.stop_x = east ? 1080 : 1000;
        rock.stop_y = east ? 0 : 110;
      }
  ClearancePlan plan;
  plan.probability = 0.05;
  plan.sectors = 4;
  ClearancePlan of_east = plan;
  of_east.group = 0;
  ClearanceTally tally({plan, of_east});
  do tally.add(records);
  while (tally.needs_another_pass());
  const auto found = tally.summaries();
  CHECK(found[0].area.centre.isApprox(Vec2(1000, 0), 1e-12));
  CHECK(found[0].area.hull.size() == 4);
  CHECK(found[0].area.sectors[0].count == 441);  // due east: the first sector, from 0 on
  CHECK(found[0].area.sectors[0].greatest.value == Approx(30));
  CHECK(found[0].area.sectors[1].greatest.value == Approx(60));
  CHECK(found[0].distance.value == Approx(60));
  CHECK(found[1].distance.value == Approx(30));
  CHECK(found[1].count == 441);
  CHECK(found[1].area.sectors[1].count == 0);
  CHECK(std::isnan(found[1].area.sectors[1].greatest.value));
}

TEST_CASE("a clearance of a group is of its rocks alone, also per blast, and counts the rocks of a blast") {
  TrialRecords records;
  for (int trial = 0; trial < 100; ++trial)
    for (int i = 0; i < 5; ++i) {
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = static_cast<std::uint64_t>(trial);
      rock.rock = i;
      rock.group = i < 3 ? 0 : 1;
      rock.reason = StopReason::stopped;
      rock.runout = i < 3 ? 10 + i : 500;
    }
  ClearancePlan of_first;
  of_first.probability = 0.1;
  of_first.group = 0;
  ClearancePlan of_blasts = of_first, of_all = of_first;
  of_blasts.per_blast = of_all.per_blast = true;
  of_all.group = -1;
  ClearanceTally tally({of_first, of_blasts, of_all});
  do tally.add(records);
  while (tally.needs_another_pass());
  const auto found = tally.summaries();
  CHECK(found[0].count == 300);
  CHECK(found[0].distance.value == 12);
  CHECK(found[1].count == 100);
  CHECK(found[1].distance.value == 12);
  CHECK(found[1].rocks_per_blast() == 3);
  CHECK(found[2].distance.value == 500);
  CHECK(found[2].rocks_per_blast() == 5);
}
