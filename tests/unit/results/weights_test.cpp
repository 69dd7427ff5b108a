// Rocks that stand for several real ones, in the numbers over several groups.

#include "results/say/weights.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "report/tables/tables.h"
#include "results/say/answer.h"
#include "unit/results/fake_results.h"

using namespace flyrock;

namespace {

constexpr double weight_of_blocks = 1, weight_of_stones = 9;

/// Blocks of which all go 100 m and pass the road, stones of which all go 10 m; each trial has one of both.
TrialRecords of_two_groups(std::uint64_t trials) {
  TrialRecords records = fake::records(trials);
  records.trajectories.clear();
  for (RockRecord& rock : records.rocks) {
    rock.reason = StopReason::stopped;
    rock.censored = false;
    rock.runout = rock.group == 0 ? 100 : 10;
    rock.weight = rock.group == 0 ? weight_of_blocks : weight_of_stones;
    if (rock.group == 0) records.gates.push_back({rock.trial, rock.rock, {{0, 5, 100, 1, 0}, 0}});
  }
  return records;
}

Plan of_weighted_groups(std::uint64_t trials) {
  Plan plan = fake::plan(trials);
  plan.points[0].rocks[0].weight = weight_of_blocks;
  plan.points[0].rocks[1].weight = weight_of_stones;
  plan.points[0].gates = {{"road", 50}};
  return plan;
}

Results weighted_results_of(const Plan& plan, const TrialRecords& records) {
  Results results = make_results(plan, {rows_of(records)}, {{plan.points[0].trials}, true, "", {}});
  results.points[0].terrain = fake::bench();
  return results;
}

}  // namespace

TEST_CASE("Two groups of known shares are weighted in every number over both") {
  constexpr std::uint64_t trials = 200;
  const Plan plan = of_weighted_groups(trials);
  const Results results = weighted_results_of(plan, of_two_groups(trials));
  const PointResult& point = results.points[0];
  const auto of_all = [&](Statistic statistic) {
    return point.groups[0].at(rock_statistic("runout"), statistic).value;
  };
  CHECK(of_all(Statistic::mean) == Approx(0.1 * 100 + 0.9 * 10));
  CHECK(of_all(Statistic::p50) == 10);
  CHECK(of_all(Statistic::p95) == 100);
  CHECK(point.groups[1].at(rock_statistic("runout"), Statistic::mean).value == Approx(100));
  const Shares& passed = point.crossings[0].gates[0].shares;
  CHECK(passed.of_all.value == Approx(0.1));
  CHECK(passed.per_trial.value == 1);
  // Of the blocks alone all pass, whatever they weigh.
  CHECK(point.crossings[1].gates[0].shares.of_all.value == 1);
  CHECK(point.crossings[1].gates[0].shares.per_trial.value == 1);
}

TEST_CASE("Without weights the answer gives each group and no mixture") {
  constexpr std::uint64_t trials = 200;
  const Plan weighted = of_weighted_groups(trials);
  Plan plain = weighted;
  TrialRecords records = of_two_groups(trials);
  const std::string text = answer(weighted, weighted_results_of(weighted, records));
  CHECK(text.find("all (weighted)") != std::string::npos);
  CHECK(text.find("known between bounds") != std::string::npos);
  for (RockGroup& group : plain.points[0].rocks) group.weight.reset();
  for (RockRecord& rock : records.rocks) rock.weight = 1;
  const std::string unweighted = answer(plain, weighted_results_of(plain, records));
  CHECK(unweighted.find("weighted") == std::string::npos);
  CHECK(unweighted.find("blocks 100 m") != std::string::npos);
}

TEST_CASE("rocks.csv has weights where rocks have them") {
  const Plan plan = of_weighted_groups(1);
  const TrialRecords records = of_two_groups(1);
  CHECK(rocks_csv_header(plan, true).find(",group,weight,mass_kg,") != std::string::npos);
  CHECK(rocks_csv_header(plan, false).find("weight") == std::string::npos);
  CHECK(rocks_csv_rows(plan, 0, records.rocks, true).find(",\"loose, small\",9,") != std::string::npos);
}
