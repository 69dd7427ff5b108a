// Paired differences of sweep points, against closed forms.

#include "results/differences.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "scenario/plan.h"

using namespace flyrock;

namespace differences_test {

/// The rocks of one point: `per_trial` rocks in each trial, whose runouts are `runout(trial, rock)`.
template <class Runout>
TrialRecords rocks(int trials, int per_trial, Runout runout) {
  TrialRecords records;
  for (int t = 0; t < trials; ++t)
    for (int r = 0; r < per_trial; ++r) {
      RockRecord rock;
      rock.trial = static_cast<std::uint64_t>(t);
      rock.rock = r;
      rock.reason = StopReason::stopped;
      rock.runout = runout(t, r);
      records.rocks.push_back(rock);
    }
  return records;
}

Plan two_points() {
  Plan plan;
  plan.points.resize(2);
  for (Scenario& point : plan.points) {
    point.rocks.resize(1);
    point.gates = {{"road", 10}};
    point.barriers = {{"fence", 20, 2, 2000}};
  }
  return plan;
}

/// The differences of the second point from the first.
PointDifferences compare(const Plan& plan, const TrialRecords& at_0, const TrialRecords& at_1) {
  std::vector<PointResult> points(2);
  for (PointResult& point : points) point.groups.resize(1);
  return make_differences(plan, points, {rows_of(at_0), rows_of(at_1)}).at(0);
}

const Difference& of(const PointDifferences& differences, const std::string& name, std::size_t group = 0) {
  const std::vector<ComparedNumber> compared = compared_numbers(two_points().points.front());
  for (std::size_t i = 0; i < compared.size(); ++i)
    if (compared[i].name == name) return differences.groups.at(group).numbers.at(i);
  throw std::logic_error("no number " + name);
}

}  // namespace differences_test

using namespace differences_test;

TEST_CASE("The interval of a difference of two laws holds the closed form in 91 to 99 % of the seeds") {
  // Independent normals: the mean of x_1 - x_0 is 5 m, whatever the trial adds to both, and to each.
  for (const int per_trial : {1, 5}) {
    int holds = 0;
    constexpr int seeds = 200;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      std::mt19937 dice(seed);
      std::normal_distribution<double> normal;
      const auto point = [&](double mean, double sd) {
        double of_trial = 0;
        return rocks(40, per_trial, [&](int, int r) {
          if (r == 0) of_trial = 3 * normal(dice);
          return mean + of_trial + sd * normal(dice);
        });
      };
      const TrialRecords first = point(100, 8), second = point(105, 12);
      const PointDifferences differences = compare(two_points(), first, second);
      const Interval interval = of(differences, "runout").interval;
      holds += interval.lower <= 5 && 5 <= interval.upper;
    }
    INFO(per_trial << " rocks a trial");
    CHECK(holds >= 0.91 * seeds);
    CHECK(holds <= 0.99 * seeds);
  }
}

TEST_CASE("Pairs of the same rock differ by what the law changes and not by what they share") {
  std::mt19937 dice(3);
  std::normal_distribution<double> normal(1e6, 1000);
  const TrialRecords first = rocks(50, 2, [&](int, int) { return normal(dice); });
  TrialRecords second = first;
  for (RockRecord& rock : second.rocks) rock.runout += rock.rock == 0 ? 1 : 3;
  const Difference difference = of(compare(two_points(), first, second), "runout");
  CHECK(difference.pairs == 100);
  CHECK(difference.differing == 50);
  CHECK(difference.mean == Approx(2).epsilon(1e-9));
  // Each trial has the same sum; two numbers of a trial are no more certain than 100 independent ones.
  CHECK(difference.interval.lower == Approx(2 - 2.0096 / std::sqrt(99)).epsilon(1e-3));
  CHECK(of(compare(two_points(), first, first), "runout").mean == 0);
}

TEST_CASE("Rocks are paired by trial, group and number in the group, also where a point has more rocks") {
  Plan plan = two_points();
  for (Scenario& point : plan.points) {
    point.rocks.resize(2);
    point.rocks[0].name = "a";
    point.rocks[1].name = "b";
  }
  // Point 1 has one more rock of group a in each trial: those of b have other numbers in the trial.
  TrialRecords first = rocks(20, 2, [](int t, int r) { return t + 100.0 * r; });
  TrialRecords second = rocks(20, 3, [](int t, int r) { return t + (r < 2 ? 0 : 107.0); });
  for (RockRecord& rock : first.rocks) rock.group = rock.rock;
  for (RockRecord& rock : second.rocks) rock.group = rock.rock / 2;
  const PointDifferences differences = compare(plan, first, second);
  REQUIRE(differences.groups.size() == 3);
  CHECK(of(differences, "runout", 1).mean == 0);
  CHECK(of(differences, "runout", 2).mean == 7);
  CHECK(differences.groups[0].unpaired == 20);
  CHECK(differences.groups[1].unpaired == 20);
  CHECK(differences.groups[2].unpaired == 0);
}

TEST_CASE("Censored pairs are counted apart, failed rocks have no partner") {
  const TrialRecords first = rocks(30, 1, [](int t, int) { return t; });
  TrialRecords second = rocks(30, 1, [](int t, int) { return 2.0 * t; });
  second.rocks[3].censored = true;
  second.rocks[3].reason = StopReason::timed_out;
  second.rocks[4].reason = StopReason::diverged;
  second.gates.push_back({5, 0, {{}, 0}});
  second.rocks[6].censored = true;
  second.rocks[6].reason = StopReason::left_domain;
  second.rocks[6].decided_gates = second.rocks[6].decided_barriers = 1;
  const PointDifferences differences = compare(two_points(), first, second);
  CHECK(of(differences, "runout").censored == 2);
  CHECK(of(differences, "runout").pairs == 27);
  CHECK(differences.groups[0].unpaired == 2);
  const Difference& passed = of(differences, "gate.road.passed");
  CHECK(passed.mean == Approx(1.0 / 28));
  CHECK(passed.censored == 1);  // the other one can no longer arrive
  CHECK(passed.interval.trials_needed > 0);
  CHECK(of(differences, "barrier.fence.caught").differing == 0);
}

TEST_CASE("Differences need rows, and say so") {
  Plan plan = two_points();
  for (Scenario& point : plan.points) point.output.rocks = false;
  const TrialRecords records = rocks(20, 1, [](int t, int) { return t; });
  CHECK(compare(plan, records, records).reason == "rows");
  CHECK(compare(plan, records, records).groups.empty());
}
