// Intervals of rocks that share the draws of their trial.
#include "results/design_effect.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "results/share.h"

using namespace flyrock;

namespace design_effects {

/// Numbers of trials that share a part `common` of their variance: exp(z / 2) with a standard normal z.
struct Numbers {
  int rocks;
  double common;
  std::vector<double> values;

  Numbers(std::uint64_t seed, int trials, int rocks_, double common_) : rocks(rocks_), common(common_) {
    std::mt19937_64 random(seed);
    std::normal_distribution<> normal;
    for (int t = 0; t < trials; ++t) {
      const double of_trial = std::sqrt(common) * normal(random);
      for (int i = 0; i < rocks; ++i)
        values.push_back(std::exp(0.5 * (of_trial + std::sqrt(1 - common) * normal(random))));
    }
  }
  std::uint64_t trial(std::size_t i) const { return i / static_cast<std::size_t>(rocks); }
};

Sample sample_of(const Numbers& numbers) {
  Sample sample(Questions{{0.95}, {{0.95, 0.95}}});
  do {
    for (std::size_t i = 0; i < numbers.values.size(); ++i)
      sample.add({numbers.values[i], false}, numbers.trial(i));
  } while (sample.needs_another_pass());
  return sample;
}

Share share_above(const Numbers& numbers, double limit) {
  ShareTally tally;
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    tally.add(numbers.trial(i));
    if (numbers.values[i] > limit) tally.count();
  }
  tally.close();
  return tally.of_rocks();
}

bool holds(const Interval& interval, double truth) {
  return interval.lower <= truth && truth <= interval.upper;
}

}  // namespace design_effects

TEST_CASE("The design effect of trials whose rocks do the same is the number of rocks") {
  TrialCounts counts;
  for (int t = 0; t < 1000; ++t) counts.add(20, t % 10 == 0 ? 20 : 0);
  CHECK(counts.share() == 0.1);
  CHECK(counts.design_effect() == Approx(20).epsilon(2e-3));
  TrialCounts alone;
  for (int t = 0; t < 1000; ++t) alone.add(1, t % 10 == 0);
  CHECK(alone.design_effect() == 1);
  // Rocks that avoid each other say no less than independent ones.
  TrialCounts even;
  for (int t = 0; t < 1000; ++t) even.add(10, 1);
  CHECK(even.design_effect() == 1);
}

TEST_CASE("Fewer than ten trials beyond a number give no interval but how many trials it takes") {
  ShareTally tally;
  for (std::uint64_t t = 0; t < 100; ++t)
    for (int i = 0; i < 5; ++i) {
      tally.add(t);
      if (t < 4) tally.count();
    }
  tally.close();
  const Interval interval = tally.of_rocks().interval;
  CHECK(std::isnan(interval.lower));
  CHECK(std::isnan(interval.upper));
  CHECK(interval.trials_needed == 250);
  CHECK(tally.per_trial().interval.upper == share_interval(4, 100, 0.95).upper);
}

TEST_CASE("Intervals by trial contain the truth in 92 to 99 % of runs, whatever rocks share", "[slow]") {
  using namespace design_effects;
  const double p95 = std::exp(0.5 * 1.6448536269514722), mean = std::exp(0.125);
  for (const auto& [trials, rocks, common] :
       {std::tuple{200, 20, 0.3}, {200, 20, 0.9}, {100, 200, 0.3}, {150, 200, 0.9}, {400, 1, 0.9}}) {
    constexpr int seeds = 400;
    int of_mean = 0, of_p95 = 0, of_share = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Numbers numbers(seed, trials, rocks, common);
      const Sample sample = design_effects::sample_of(numbers);
      of_mean += holds(sample.mean_interval(0.95), mean);
      of_p95 += holds(sample.quantile_interval(0.95, 0.95), p95);
      of_share += holds(share_above(numbers, p95).interval, 0.05);
    }
    INFO(trials << " trials of " << rocks << " rocks, common part " << common);
    for (const int held : {of_mean, of_p95, of_share}) {
      CHECK(held >= 0.92 * seeds);
      CHECK(held <= 0.99 * seeds);
    }
  }
}
