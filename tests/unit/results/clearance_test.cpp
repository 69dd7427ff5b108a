// Clearances: their safety factor, their areas, their groups.

#include "results/measured/clearance.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/plan_hull.h"
#include "random/stream.h"

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

TEST_CASE("as many rocks stop outside of an area as order statistics allow") {
  // Wilks 1941: with one sector, 59 rocks bound 95 % of all with 95 % confidence, 93 with one outside.
  CHECK_FALSE(rocks_beyond(1, 58, 0.05));
  CHECK(rocks_beyond(1, 59, 0.05) == 0);
  CHECK(rocks_beyond(1, 92, 0.05) == 0);
  CHECK(rocks_beyond(1, 93, 0.05) == 1);
  // Two sectors without a rock outside are one with one outside.
  CHECK_FALSE(rocks_beyond(2, 92, 0.05));
  CHECK(rocks_beyond(2, 93, 0.05) == 0);
}

TEST_CASE("an area ends in each sector where the same number of rocks lies beyond") {
  // Due +y 1000 rocks at 1 to 1000 m from (10, 20); due -x five rocks, one of which was cut short.
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
  for (int i = 1; i <= 5; ++i) add(10 - i, 20.001, i == 5);
  ClearancePlan plan;
  plan.probability = 0.05;
  plan.factor = 2;
  plan.sectors = 5;  // 72 degrees each: +y in the second, -x in the third
  plan.about = Vec2(10, 20);
  ClearanceTally tally({plan});
  do tally.add(records);
  while (tally.needs_another_pass());
  const ClearanceSummary found = tally.summaries()[0];
  CHECK(found.area.effective == 1005);
  REQUIRE(found.area.beyond == 6);
  const auto sectors = found.area.sectors;
  REQUIRE(sectors.size() == 5);
  CHECK(sectors[1].azimuth == Approx(108 * pi / 180));
  CHECK(sectors[1].count == 1000);
  CHECK(sectors[1].distance.value == 994);  // six lie beyond
  CHECK(sectors[1].with_factor == 2 * sectors[1].distance.value);
  CHECK(sectors[1].greatest.value == 1000);
  CHECK(sectors[1].share.value == Approx(1000.0 / 1005));
  // Too few rocks: all of them may be outside.
  CHECK(sectors[2].count == 5);
  CHECK(sectors[2].greatest.value == Approx(5));
  CHECK(sectors[2].distance.value == 0);
  CHECK(sectors[2].distance.censored);
  // The farthest of the area is what the clearance says; the rock that was cut short may have gone farther.
  CHECK(found.enough());
  CHECK(found.distance.value == 994);
  CHECK(found.with_factor == sectors[1].with_factor);
  CHECK(found.distance.censored);
  CHECK(sectors[0].count == 0);
  CHECK(sectors[0].distance.value == 0);
  CHECK(std::isnan(sectors[0].greatest.value));
}

namespace {

/// Rocks thrown from a square of 10 m in all directions; those of a blast share its strength.
TrialRecords thrown(std::uint64_t seed, int blasts, int rocks) {
  TrialRecords records;
  RandomStream rng(seed, hash_name("thrown"), {});
  for (int trial = 0; trial < blasts; ++trial) {
    const double strength = 1 + rng.uniform();
    for (int i = 0; i < rocks; ++i) {
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = static_cast<std::uint64_t>(trial);
      rock.rock = i;
      rock.reason = StopReason::stopped;
      rock.start_x = 10 * rng.uniform();
      rock.start_y = 10 * rng.uniform();
      const double angle = 2 * pi * rng.uniform();
      rock.runout = rock.max_distance =
          -20 * strength * (1 + 0.5 * std::cos(angle)) * std::log(rng.uniform());
      rock.stop_x = rock.start_x + rock.runout * std::cos(angle);
      rock.stop_y = rock.start_y + rock.runout * std::sin(angle);
    }
  }
  return records;
}

/// The share of rocks that stop outside of an area.
double share_outside(const AreaSummary& area, const TrialRecords& records) {
  int outside = 0;
  for (const RockRecord& rock : records.rocks) {
    const Vec2 end(rock.stop_x, rock.stop_y);
    const SectorSummary& sector = area.sectors[sector_of(end - area.centre, area.sectors.size())];
    outside += distance_from(area.hull, end) > sector.distance.value;
  }
  return outside / static_cast<double>(records.rocks.size());
}

}  // namespace

TEST_CASE("new rocks leave an area with its probability at most, also rocks that share their blast",
          "[slow]") {
  for (const int rocks : {1, 20}) {
    ClearancePlan plan;
    plan.probability = 0.05;
    plan.sectors = 12;
    int kept = 0;
    double mean = 0;
    constexpr int seeds = 200;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const TrialRecords records = thrown(seed, rocks == 1 ? 2000 : 200, rocks);
      ClearanceTally tally({plan});
      do tally.add(records);
      while (tally.needs_another_pass());
      const AreaSummary area = tally.summaries()[0].area;
      REQUIRE(area.beyond);
      const double share = share_outside(area, thrown(seed + 10'000, rocks == 1 ? 20'000 : 2000, rocks));
      kept += share <= plan.probability;
      mean += share / seeds;
    }
    INFO(rocks << " rocks a blast, mean share outside " << mean);
    CHECK(kept >= 0.92 * seeds);
    CHECK(mean >= 0.5 * plan.probability);
  }
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
  plan.probability = 0.2;
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

TEST_CASE("a clearance per blast with weights is exceeded by 1 - (1 - p)^(1/w) of the simulated blasts") {
  const std::uint64_t trials = 500;
  ClearancePlan plan{.name = "people", .probability = 0.1, .per_blast = true};
  const auto found = [&](double weight) {
    TrialRecords records;
    for (std::uint64_t trial = 0; trial < trials; ++trial)
      for (int i = 0; i < 2; ++i) {
        RockRecord& rock = records.rocks.emplace_back();
        rock.trial = trial;
        rock.rock = i;
        rock.reason = StopReason::stopped;
        rock.weight = weight;
        rock.runout = i == 0 ? static_cast<double>(trial) : 0;  // the farthest of the blasts: 0 to 499 m
      }
    ClearanceTally tally({plan});
    do tally.add(records);
    while (tally.needs_another_pass());
    return tally.summaries().front();
  };
  const ClearanceSummary one = found(1), four = found(4), many = found(100);
  CHECK(one.distance.value == Approx(499 * 0.9));
  CHECK_FALSE(one.is_upper_bound(plan));
  const double beyond = 1 - std::pow(0.9, 0.25);
  CHECK(four.distance.value == Approx(499 * (1 - beyond)));
  CHECK(four.needed == static_cast<std::uint64_t>(std::ceil(10 / beyond)));
  CHECK(four.is_upper_bound(plan));
  CHECK(four.rocks_per_blast() == 8);
  CHECK_FALSE(many.enough());
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
