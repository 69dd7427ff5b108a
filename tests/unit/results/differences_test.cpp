// Paired differences of sweep points, against closed forms.

#include "results/compare/differences.h"

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

TEST_CASE("A censored pair counts where its rock was last seen, failed rocks have no partner") {
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
  const Difference& runout = of(differences, "runout");
  CHECK(runout.censored == 2);
  CHECK(runout.pairs == 29);
  CHECK(runout.bound == DifferenceBound::at_least);
  CHECK(runout.mean == Approx((435.0 - 4) / 29));
  CHECK(std::isnan(runout.interval.lower));  // 2 of 29 are more than 5 %
  CHECK(differences.groups[0].unpaired == 2);
  const Difference& passed = of(differences, "gate.road.passed");
  CHECK(passed.mean == Approx(1.0 / 29));
  CHECK(passed.censored == 1);  // the other one can no longer arrive
  CHECK(passed.interval.trials_needed > 0);
  CHECK(of(differences, "barrier.fence.caught").differing == 0);
}

TEST_CASE("The kind of censored pairs decides which bound a mean difference is") {
  struct Case {
    const char* name;
    std::vector<int> at_0, at_1;  // censored trials
    DifferenceBound bound;
    std::uint64_t pairs, censored, left_out;
    bool has_interval;
    const char* text;
  };
  const std::vector<Case> cases = {
      {"none", {}, {}, DifferenceBound::none, 40, 0, 0, true, "+5.5 m (95 % interval"},
      {"at the point", {}, {1, 2}, DifferenceBound::at_least, 40, 2, 0, true, ">= +5.5 m (95 % interval"},
      {"at point 0", {7}, {}, DifferenceBound::at_most, 40, 1, 0, true, "<= +5.5 m (95 % interval"},
      {"many",
       {},
       {1, 2, 3},
       DifferenceBound::at_least,
       40,
       3,
       0,
       false,
       ">= +5.5 m (3 of 40 pairs are censored: they count where the rocks were last seen)"},
      {"different pairs at both",
       {1},
       {2},
       DifferenceBound::not_known,
       40,
       2,
       0,
       false,
       "not known: 2 of 40 pairs are censored"},
      {"both rocks of a pair",
       {1},
       {1},
       DifferenceBound::not_known,
       39,
       1,
       1,
       false,
       "not known: 1 of 40 pairs are censored"},
  };
  for (const Case& c : cases) {
    INFO(c.name);
    TrialRecords first = rocks(40, 1, [](int t, int) { return 10.0 * t; });
    TrialRecords second = rocks(40, 1, [](int t, int) { return 10.0 * t + 5 + (t % 2); });
    for (const int t : c.at_0) first.rocks[static_cast<std::size_t>(t)].censored = true;
    for (const int t : c.at_1) second.rocks[static_cast<std::size_t>(t)].censored = true;
    const Difference runout = of(compare(two_points(), first, second), "runout");
    CHECK(runout.bound == c.bound);
    CHECK(runout.pairs == c.pairs);
    CHECK(runout.censored == c.censored);
    CHECK(runout.left_out == c.left_out);
    CHECK(std::isnan(runout.interval.lower) == !c.has_interval);
    CHECK(std::isnan(runout.mean) == (c.bound == DifferenceBound::not_known));
    CHECK(difference_text(runout).starts_with(c.text));
  }
}

TEST_CASE("A mean difference over censored pairs bounds the true one in random tables") {
  // Distances cut off at a random length, at one point, the other, or both.
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 dice(seed);
    std::lognormal_distribution<double> throws(4, 0.6), factor(0.1, 0.3);
    std::uniform_real_distribution<double> cut(60, 300);
    std::vector<double> x_0(80), x_1(80);
    for (int t = 0; t < 80; ++t) x_1[t] = (x_0[t] = throws(dice)) * factor(dice);
    const auto cut_off = [&](const std::vector<double>& x, bool is_cut) {
      const double at = is_cut ? cut(dice) : 1e9;
      TrialRecords records = rocks(80, 1, [&](int t, int) { return std::min(x[t], at); });
      for (RockRecord& rock : records.rocks) rock.censored = rock.runout >= at;
      return records;
    };
    const TrialRecords first = cut_off(x_0, seed % 3 != 0), second = cut_off(x_1, seed % 3 != 1);
    const Difference runout = of(compare(two_points(), first, second), "runout");
    double truth = 0;
    for (int t = 0; t < 80; ++t) truth += (x_1[t] - x_0[t]) / 80;
    if (runout.bound == DifferenceBound::none) CHECK(runout.mean == Approx(truth));
    if (runout.bound == DifferenceBound::at_least) CHECK(runout.mean <= truth + 1e-9);
    if (runout.bound == DifferenceBound::at_most) CHECK(runout.mean >= truth - 1e-9);
    CHECK((runout.bound == DifferenceBound::none) == (runout.censored == 0));
  }
}

TEST_CASE("Differences need rows, and say so") {
  Plan plan = two_points();
  for (Scenario& point : plan.points) point.output.rocks = false;
  const TrialRecords records = rocks(20, 1, [](int t, int) { return t; });
  CHECK(compare(plan, records, records).reason == "rows");
  CHECK(compare(plan, records, records).groups.empty());
}
