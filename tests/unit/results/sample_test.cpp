#include "results/statistics/sample.h"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/pareto.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"
#include "record/rows.h"
#include "results/measured/clearance.h"

using namespace flyrock;

namespace {

/// Uniform numbers of one simulated study.
std::vector<double> uniforms(std::uint64_t study, int n) {
  std::vector<double> u;
  for (int i = 0; i < n; ++i)
    u.push_back(
        uniform_at(11, hash_name("coverage"), {.trial = study, .rock = static_cast<std::uint64_t>(i)}));
  return u;
}

/// What the tests below ask.
Sample of(const std::vector<Bounded>& values) {
  return sample_of(values, {{0.5, 0.9, 0.95, 0.99}, {{0.5, 0.95}, {0.95, 0.95}, {0.99, 0.95}, {0.95, 0.90}}});
}

template <class Law>
Sample draw(const Law& law, std::uint64_t study, int n) {
  std::vector<Bounded> values;
  for (const double u : uniforms(study, n)) values.push_back({boost::math::quantile(law, u), false});
  return of(values);
}

std::vector<Bounded> numbers(int n) {
  std::vector<Bounded> values;
  for (int i = n; i >= 1; --i) values.push_back({static_cast<double>(i), false});
  return values;
}

}  // namespace

TEST_CASE("The interval of a quantile is of the order statistics that tables give") {
  // n = 100, median, 95 %: x_(40) and x_(61) (Conover 1999, table of the binomial).
  const Interval median = of(numbers(100)).quantile_interval(0.5, 0.95);
  CHECK(median.lower == 40);
  CHECK(median.upper == 61);
  // Wilks 1941: the greatest of 59 values, not of 58, is beyond p95 with 95 % confidence; here a tail is 5 %.
  const Interval fifty_eight = of(numbers(58)).quantile_interval(0.95, 0.90);
  CHECK(std::isnan(fifty_eight.upper));
  CHECK(of(numbers(59)).quantile_interval(0.95, 0.90).upper == 59);
  CHECK(std::isnan(of(numbers(3)).quantile_interval(0.5, 0.95).lower));
}

TEST_CASE("Censored values take the upper end of an interval, and all of that of the mean") {
  std::vector<Bounded> values = numbers(100);
  values[0].censored = true;  // 100
  CHECK(of(values).quantile_interval(0.5, 0.95).upper == 61);
  CHECK(std::isnan(of(values).mean_interval(0.95).lower));
  values[60].censored = true;  // 40: it may truly lie anywhere above
  const Interval median = of(values).quantile_interval(0.5, 0.95);
  CHECK(median.lower == 40);
  CHECK(std::isnan(median.upper));
}

TEST_CASE("The interval of the mean is Student's") {
  const Interval mean = of({{1, false}, {2, false}, {3, false}, {4, false}}).mean_interval(0.95);
  CHECK(mean.lower == Approx(2.5 - 3.182446305284263 * 1.2909944487358056 / 2));
  CHECK(mean.upper == Approx(2.5 + 3.182446305284263 * 1.2909944487358056 / 2));
}

TEST_CASE("Quantiles of heavy-tailed samples come to the exact ones") {
  const boost::math::pareto_distribution<> pareto(1, 1.5);  // infinite variance
  const boost::math::lognormal_distribution<> lognormal(0, 1.5);
  const Sample a = draw(pareto, 0, 200000), b = draw(lognormal, 1, 200000);
  for (const double p : {0.5, 0.9, 0.95, 0.99}) {
    CHECK(a.quantile(p).value == Approx(boost::math::quantile(pareto, p)).epsilon(0.03));
    CHECK(b.quantile(p).value == Approx(boost::math::quantile(lognormal, p)).epsilon(0.03));
  }
}

TEST_CASE("Stated 95 % intervals hold the truth in 93 to 97 % of studies", "[slow]") {
  const boost::math::pareto_distribution<> pareto(1, 1.5);
  const boost::math::lognormal_distribution<> lognormal(0, 1);
  constexpr int studies = 2000, rocks = 2000;
  int p50 = 0, p95 = 0, p99 = 0, mean = 0;
  const auto holds = [](const Interval& interval, double truth) {
    return interval.lower <= truth && truth <= interval.upper;
  };
  for (std::uint64_t study = 0; study < studies; ++study) {
    const Sample heavy = draw(pareto, study, rocks);
    p50 += holds(heavy.quantile_interval(0.5, 0.95), boost::math::quantile(pareto, 0.5));
    p95 += holds(heavy.quantile_interval(0.95, 0.95), boost::math::quantile(pareto, 0.95));
    p99 += holds(heavy.quantile_interval(0.99, 0.95), boost::math::quantile(pareto, 0.99));
    mean += holds(draw(lognormal, study + studies, rocks).mean_interval(0.95), boost::math::mean(lognormal));
  }
  for (const int held : {p50, p95, p99, mean}) {
    CHECK(held >= 0.93 * studies);
    CHECK(held <= 0.97 * studies);
  }
}

TEST_CASE("A clearance is the quantile of rocks, or of the farthest rock of each blast") {
  Scenario scenario;
  ClearancePlan of_rocks{.name = "road", .probability = 0.1};
  of_rocks.factor = 1.5;
  ClearancePlan of_blasts{.name = "people", .probability = 0.1};
  of_blasts.per_blast = of_blasts.of_max_distance = true;
  scenario.clearances = {of_rocks, of_blasts, {.name = "rare", .probability = 0.01}};
  std::vector<RockRecord> rocks;
  for (int t = 0; t <= 100; ++t)
    for (int r = 0; r < 2; ++r) {
      RockRecord rock;
      rock.trial = static_cast<std::uint64_t>(t);
      rock.rock = r;
      rock.reason = StopReason::stopped;
      rock.runout = t;
      rock.max_distance = 1000 * r + t;
      rocks.push_back(rock);
    }
  const auto find = [&] {
    ClearanceTally tally(scenario.clearances);
    TrialRecords records;
    records.rocks = rocks;
    read_in_passes(rows_of(records), tally);
    return tally.summaries();
  };
  const auto summaries = find();
  CHECK(summaries[0].count == 202);
  CHECK(summaries[0].distance.value == Approx(90));
  CHECK(summaries[0].with_factor == Approx(135));
  CHECK(summaries[1].count == 101);
  CHECK(summaries[1].distance.value == Approx(1090));
  CHECK(std::isnan(summaries[1].with_factor));
  CHECK_FALSE(summaries[2].enough());
  CHECK(summaries[2].needed == 1000);
  CHECK(std::isnan(summaries[2].distance.value));

  // The near rock of the nearest blast is lost: it may have gone farther than anything.
  rocks[0].censored = true;
  rocks[0].reason = StopReason::left_domain;
  const auto lost = find();
  CHECK(lost[0].distance.censored);
  CHECK(lost[1].distance.censored);
  CHECK(std::isnan(lost[1].interval.upper));
}

TEST_CASE("Ten rocks are expected beyond a clearance") {
  CHECK(needed_for(0.01) == 1000);
  CHECK(needed_for(0.001) == 10000);
  CHECK(needed_for(0.07) == 143);
  CHECK(needed_for(0.3) == 34);
}
