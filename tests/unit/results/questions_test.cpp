// The questions of a permit: the texts of the table and of the first sentence, from counts that are known.

#include "results/say/questions.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "results/say/wording.h"
#include "results/statistics/share.h"

using namespace flyrock;

namespace questions_test {

/// 1000 blasts of two rocks: the farthest of blast i goes i metres, the other one stays.
TrialRecords blasts() {
  TrialRecords records;
  for (std::uint64_t trial = 0; trial < 1000; ++trial)
    for (int i = 0; i < 2; ++i) {
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = trial;
      rock.rock = i;
      rock.reason = StopReason::stopped;
      rock.runout = i == 0 ? static_cast<double>(trial) : 0;
    }
  return records;
}

std::vector<Question> asked_of(const ClearancePlan& plan, const TrialRecords& records) {
  ClearanceTally tally({plan});
  do tally.add(records);
  while (tally.needs_another_pass());
  Scenario scenario;
  scenario.clearances = {plan};
  PointResult point;
  point.groups.resize(1);
  point.clearances = tally.summaries();
  return questions(scenario, point);
}

ClearancePlan per_blast() { return {.name = "people", .probability = 0.05, .per_blast = true}; }

Question asked_of(const ExposurePlan& plan, double share, Interval interval) {
  Scenario scenario;
  scenario.exposures = {plan};
  PointResult point;
  point.groups.resize(1);
  ExposureSummary found;
  found.radius = 12;
  found.per_blast = {share, share, interval, 1};
  found.per_year = carried(share, plan.blasts_per_year);
  found.per_year_interval = {carried(interval.lower, plan.blasts_per_year),
                             carried(interval.upper, plan.blasts_per_year)};
  point.exposures = {found};
  return questions(scenario, point).at(0);
}

ExposurePlan house() {
  ExposurePlan plan;
  plan.name = "house";
  plan.energy = 20;
  plan.blasts_per_year = 100;
  return plan;
}

}  // namespace questions_test

using questions_test::asked_of;

TEST_CASE("a clearance per blast says one blast in how many throws how far, and what its limit is worth") {
  ClearancePlan plan = questions_test::per_blast();
  plan.customary = 700;
  plan.blasts_per_year = 50;
  const std::vector<Question> rows = asked_of(plan, questions_test::blasts());
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].asks == "people: a rock beyond 949 m");  // 999 x 0.95
  CHECK(rows[0].per_blast == "5 %, one in 20");
  CHECK(rows[0].per_year == "92.3 % in 50 blasts");  // 1 - 0.95^50
  CHECK(rows[0].limit == "700 m, customary");
  CHECK(rows[0].verdict == "not held");
  // 299 of 1000 go beyond 700 m; R: binom.test(299, 1000)
  const Interval exact = share_interval(299, 1000, 0.95);
  CHECK(rows[1].asks == "people: a rock beyond 700 m, customary");
  CHECK(rows[1].per_blast == "29.9 %, one in 3.3");
  CHECK(rows[1].interval == "27.1 to 32.8 %");
  CHECK(exact.lower == Approx(0.271).epsilon(2e-3));
  CHECK(rows[1].verdict.empty());
  CHECK(first_sentence(rows) ==
        "One blast in 20 throws a rock beyond 949 m; one in 3.3 throws one beyond the customary 700 m.");
}

TEST_CASE("a limit is held if the whole interval keeps it, not held if all exceeds it, else not shown") {
  ClearancePlan plan = questions_test::per_blast();
  const auto verdict = [&](double customary, std::optional<double> factor) {
    plan.customary = customary;
    plan.factor = factor;
    return asked_of(plan, questions_test::blasts())[0].verdict;
  };
  CHECK(verdict(980, {}) == "held");
  CHECK(verdict(950, {}) == "not shown");
  CHECK(verdict(900, {}) == "not held");
  CHECK(verdict(980, 1.5) == "not held");  // 1424 m
  CHECK(verdict(1500, 1.5) == "held");
  ExposurePlan house = questions_test::house();
  house.limit_per_blast = 0.01;
  CHECK(asked_of(house, 0.005, {0.004, 0.006}).verdict == "held");
  CHECK(asked_of(house, 0.009, {0.007, 0.011}).verdict == "not shown");
  CHECK(asked_of(house, 0.02, {0.015, 0.03}).verdict == "not held");
  house.limit_per_year = 0.1;  // 1 - 0.995^100 is 39 %: the worse one of both counts
  const Question both = asked_of(house, 0.005, {0.004, 0.006});
  CHECK(both.limit == "1 % a blast, 10 % a year");
  CHECK(both.verdict == "not held");
}

TEST_CASE("who is hit stands in a row with its interval and its year, and in a clause") {
  const Question row = asked_of(questions_test::house(), 0.005, {0.004, 0.006});
  CHECK(row.asks == "house: hit by a rock of 20 J or more");
  CHECK(row.per_blast == "0.5 %, one in 200");
  CHECK(row.interval == "0.4 to 0.6 %");
  CHECK(row.per_year == "39.4 % in 100 blasts");  // 1 - 0.995^100
  CHECK(row.limit.empty());
  CHECK(row.verdict.empty());
  CHECK(row.clause == "one blast in 200 hits house");
  ExposurePlan road = questions_test::house();
  road.name = "road";
  road.line = {{0, 0}, {1, 0}};
  road.is_stream = true;
  road.energy = 0;
  const Question stream = asked_of(road, 0.005, {0.004, 0.006});
  CHECK(stream.asks == "road: a vehicle is hit");
  CHECK(stream.clause == "one blast in 200 hits a vehicle on road");
}

TEST_CASE("where no rock landed near, the bound stands, and a sure hit is said in percent") {
  const Question none = asked_of(questions_test::house(), 0, {0, 0.002});
  CHECK(none.per_blast == "below 0.2 %, one in 500");
  CHECK(none.interval == "no rock within 12 m");
  CHECK(none.per_year == "below 18.1 % in 100 blasts");  // 1 - 0.998^100
  CHECK(none.clause == "fewer than one blast in 500 hits house");
  const Question sure = asked_of(questions_test::house(), 0.9, {0.8, 0.95});
  CHECK(sure.per_blast == "90 %");
  CHECK(sure.per_year == "above 99.9 % in 100 blasts");
  CHECK(sure.clause == "90 % of the blasts hit house");
}

TEST_CASE("a clearance per rock also says how many blasts throw a rock so far") {
  ClearancePlan plan{.name = "road", .probability = 0.05};
  const std::vector<Question> rows = asked_of(plan, questions_test::blasts());
  REQUIRE(rows.size() == 1);
  // Of 2000 rocks 5 % go beyond 899 m: those of the last 100 blasts.
  CHECK(rows[0].asks == "road: a rock beyond 899 m, which 5 % of the rocks exceed");
  CHECK(rows[0].per_blast == "10 %, one in 10");
  CHECK(rows[0].clause == "one rock in 20 goes beyond 899 m, and one blast in 10 throws such a rock");
  TrialRecords one_each = questions_test::blasts();
  std::erase_if(one_each.rocks, [](const RockRecord& rock) { return rock.rock > 0; });
  const Question single = asked_of(plan, one_each)[0];
  CHECK(single.asks == "road: a rock beyond 949 m");
  CHECK(single.clause == "one rock in 20 goes beyond 949 m");
}

TEST_CASE("a distance that too few blasts reach is not given, and its limit is not shown to hold") {
  ClearancePlan plan = questions_test::per_blast();
  plan.probability = 0.001;
  plan.customary = 2000;
  const std::vector<Question> rows = asked_of(plan, questions_test::blasts());
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].per_blast == "not given");
  CHECK(rows[0].interval == "too few blasts: 1000 of 10000 needed");
  CHECK(rows[0].verdict == "not shown");
  // None of 1000 goes so far: the upper end is 1 - 0.025^(1/1000).
  CHECK(rows[1].per_blast == "below 0.368 %, one in 272");
  CHECK(first_sentence(rows) ==
        "The distance of people is not given (too few blasts: 1000 of 10000 needed); fewer than one blast in "
        "272 throws one beyond the customary 2000 m.");
}

TEST_CASE("a rock that was cut short makes the share beyond the customary distance a lower bound") {
  ClearancePlan plan = questions_test::per_blast();
  plan.customary = 700;
  TrialRecords records = questions_test::blasts();
  records.rocks[0].reason = StopReason::left_domain;
  records.rocks[0].censored = true;
  const std::vector<Question> rows = asked_of(plan, records);
  CHECK(rows[1].per_blast == "at least 29.9 %, one in 3.3");
  const Interval upper = share_interval(300, 1000, 0.95);
  CHECK(rows[1].interval == "27.1 to " + percent(upper.upper));
}
