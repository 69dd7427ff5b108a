#include "results/statistics/statistics.h"

#include <catch2/catch.hpp>

#include "record/rows.h"

using namespace flyrock;

namespace {

std::vector<Bounded> known(std::initializer_list<double> values) {
  std::vector<Bounded> list;
  for (double v : values) list.push_back({v, false});
  return list;
}

Statistics statistics_of(const std::vector<Bounded>& values) {
  return flyrock::statistics_of(sample_of(values, stated_questions()));
}

std::vector<GroupSummary> summarise(const std::vector<RockRecord>& rocks,
                                    const std::vector<std::string>& groups) {
  RockTally tally(groups);
  TrialRecords records;
  records.rocks = rocks;
  read_in_passes(rows_of(records), tally);
  return tally.summaries();
}

const Bounded& get(const Statistics& statistics, Statistic which) {
  return statistics[static_cast<int>(which)];
}

RockRecord rock(int group, double runout, StopReason reason = StopReason::stopped) {
  RockRecord record;
  record.group = group;
  record.runout = runout;
  record.reason = reason;
  record.censored = reason == StopReason::left_domain || reason == StopReason::timed_out;
  return record;
}

}  // namespace

TEST_CASE("Statistics of a sample, quantiles linear between order statistics") {
  const Statistics s = statistics_of(known({4, 1, 3, 2}));
  CHECK(get(s, Statistic::mean).value == 2.5);
  CHECK(get(s, Statistic::sd).value == Approx(1.2909944487358056));  // sqrt(5/3)
  CHECK(get(s, Statistic::min).value == 1);
  CHECK(get(s, Statistic::max).value == 4);
  CHECK(get(s, Statistic::p50).value == 2.5);
  CHECK(get(s, Statistic::p90).value == Approx(3.7));  // numpy.percentile([1, 2, 3, 4], 90)
  CHECK(get(s, Statistic::p99).value == Approx(3.97));
  for (const Bounded& number : s) CHECK_FALSE(number.censored);
}

TEST_CASE("Too few values have no statistics") {
  for (const Bounded& number : statistics_of(std::vector<Bounded>{})) CHECK(std::isnan(number.value));
  const Statistics one = statistics_of(known({5}));
  CHECK(get(one, Statistic::p95).value == 5);
  CHECK(std::isnan(get(one, Statistic::sd).value));
}

TEST_CASE("A percentile is a lower bound where censored values can reach into it") {
  // 0, 1, ..., 100; p90 reads the order statistic 90, p95 that of 95.
  std::vector<Bounded> values;
  for (int i = 0; i <= 100; ++i) values.push_back({static_cast<double>(i), i >= 93});
  const Statistics s = statistics_of(values);
  CHECK_FALSE(get(s, Statistic::min).censored);
  CHECK_FALSE(get(s, Statistic::p50).censored);
  CHECK_FALSE(get(s, Statistic::p90).censored);
  CHECK(get(s, Statistic::p95).censored);
  CHECK(get(s, Statistic::max).censored);
  CHECK(get(s, Statistic::mean).censored);

  // One rock lost at a short distance may have gone anywhere: what lies above it is not known.
  values.assign(101, {10, false});
  values[0] = {5, true};
  CHECK(get(statistics_of(values), Statistic::p50).censored);
  // A known value sorts before a censored one that is equal: the percentile is then known.
  values[0] = {10, true};
  CHECK_FALSE(get(statistics_of(values), Statistic::p50).censored);
}

TEST_CASE("Rocks that failed are counted and in no statistic") {
  const std::vector<RockRecord> rocks = {rock(0, 10), rock(0, 1e9, StopReason::diverged), rock(1, 20),
                                         rock(1, 30, StopReason::left_domain)};
  const auto groups = summarise(rocks, {"blocks", "loose"});
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].count == 4);
  CHECK(groups[0].faults == 1);
  CHECK(groups[0].censored_share.value == Approx(1.0 / 3));
  CHECK(groups[0].at(rock_statistic("runout"), Statistic::max).value == 30);
  CHECK(groups[0].at(rock_statistic("runout"), Statistic::max).censored);
  CHECK(groups[1].name == "blocks");
  CHECK(groups[1].at(rock_statistic("runout"), Statistic::mean).value == 10);
  CHECK(groups[2].reasons[static_cast<int>(StopReason::left_domain)] == 1);
  CHECK(summarise(rocks, {"a", "b"}).size() == 3);
  CHECK(summarise({}, {"only"}).size() == 1);
}

TEST_CASE("A rock that had landed has a known flight range although it was lost later") {
  RockRecord lost = rock(0, 100, StopReason::left_domain);
  lost.flight_range = 12;
  CHECK(bounded(lost, rock_statistics[rock_statistic("flight_range")]).censored);
  lost.impacts = 1;  // of another rock, in the air
  CHECK(bounded(lost, rock_statistics[rock_statistic("flight_range")]).censored);
  lost.landed = true;
  CHECK_FALSE(bounded(lost, rock_statistics[rock_statistic("flight_range")]).censored);
  CHECK(bounded(lost, rock_statistics[rock_statistic("energy")]).censored);
}
