// Intervals of rocks that share the draws of their trial.
#include "results/statistics/design_effect.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "results/statistics/share.h"

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

namespace weighted_samples {

/// Two populations of exponential numbers: `weight` times as many near ones (mean 1) as far ones (mean 5).
/// The sample has equally many of both, one far and some near ones a trial.
struct TwoGroups {
  static constexpr double weight = 99, near_mean = 1, far_mean = 5;
  int trials, rocks;
  std::vector<double> values, weights;
  std::vector<std::uint64_t> trial;

  TwoGroups(std::uint64_t seed, int trials_, int rocks_) : trials(trials_), rocks(rocks_) {
    std::mt19937_64 random(seed);
    std::exponential_distribution<> standard;
    for (int t = 0; t < trials; ++t)
      for (int i = 0; i < 2 * rocks; ++i) {
        values.push_back((i % 2 == 0 ? near_mean : far_mean) * standard(random));
        weights.push_back(i % 2 == 0 ? weight : 1);
        trial.push_back(static_cast<std::uint64_t>(t));
      }
  }
  static double share_beyond(double x) {
    return (weight * std::exp(-x / near_mean) + std::exp(-x / far_mean)) / (weight + 1);
  }
  static double mean() { return (weight * near_mean + far_mean) / (weight + 1); }
  static double quantile(double p) {
    double low = 0, high = 100;
    for (int i = 0; i < 100; ++i)
      (share_beyond(0.5 * (low + high)) > 1 - p ? low : high) = 0.5 * (low + high);
    return low;
  }

  Sample sample(double scale = 1) const {
    Sample sample(Questions{{0, 0.5, 0.95, 1}, {{0.5, 0.95}, {0.95, 0.95}}});
    do {
      for (std::size_t i = 0; i < values.size(); ++i)
        sample.add({values[i], false}, trial[i], scale * weights[i]);
    } while (sample.needs_another_pass());
    return sample;
  }
  Share share_above(double limit, double scale = 1) const {
    ShareTally tally;
    for (std::size_t i = 0; i < values.size(); ++i) {
      tally.add(trial[i], scale * weights[i]);
      if (values[i] > limit) tally.count();
    }
    tally.close();
    return tally.of_rocks();
  }
};

}  // namespace weighted_samples

TEST_CASE("A weighted sample has the mean, the shares and the percentiles of the rocks that it stands for") {
  using namespace weighted_samples;
  const TwoGroups groups(7, 20'000, 1);
  const Sample sample = groups.sample();
  CHECK(sample.moments().mean == Approx(TwoGroups::mean()).epsilon(0.02));
  CHECK(sample.quantile(0.5).value == Approx(TwoGroups::quantile(0.5)).epsilon(0.03));
  CHECK(sample.quantile(0.95).value == Approx(TwoGroups::quantile(0.95)).epsilon(0.03));
  CHECK(groups.share_above(2).value == Approx(TwoGroups::share_beyond(2)).epsilon(0.03));
  CHECK(sample.quantile(0).value == *std::min_element(groups.values.begin(), groups.values.end()));
  CHECK(sample.quantile(1).value == *std::max_element(groups.values.begin(), groups.values.end()));
  // In other units the weights say the same.
  const Sample tons = groups.sample(1e-3);
  CHECK(tons.moments().mean == Approx(sample.moments().mean).epsilon(1e-12));
  CHECK(tons.moments().sd == Approx(sample.moments().sd).epsilon(1e-12));
  CHECK(tons.quantile(0.95).value == sample.quantile(0.95).value);
}

TEST_CASE("A thousand rocks with weights say what all hundred thousand say") {
  using weighted_samples::TwoGroups;
  std::mt19937_64 random(3);
  std::exponential_distribution<> standard;
  std::vector<double> small(99'000), large(1'000);
  for (double& x : small) x = standard(random);
  for (double& x : large) x = 5 * standard(random);
  std::vector<Bounded> all;
  Sample some(Questions{{0.95}, {{0.95, 0.95}}});
  for (const double x : small) all.push_back({x, false});
  for (const double x : large) all.push_back({x, false});
  do {
    for (std::uint64_t i = 0; i < 500; ++i) {
      some.add({small[i], false}, i, 198);
      some.add({large[i], false}, i, 2);
    }
  } while (some.needs_another_pass());
  const Sample whole = sample_of(all, Questions{{0.95}, {{0.95, 0.95}}});
  CHECK(design_effects::holds(some.mean_interval(0.95), whole.moments().mean));
  CHECK(design_effects::holds(some.quantile_interval(0.95, 0.95), whole.quantile(0.95).value));
}

TEST_CASE("Equal weights change nothing") {
  const auto numbers = [](double weight, std::uint64_t rocks_a_trial) {
    Sample sample(Questions{{0.95}, {{0.95, 0.95}}});
    std::mt19937_64 random(1);
    std::exponential_distribution<> standard;
    std::vector<double> values(2000);
    for (double& x : values) x = standard(random);
    do {
      for (std::size_t i = 0; i < values.size(); ++i)
        sample.add({values[i], false}, i / rocks_a_trial, weight);
    } while (sample.needs_another_pass());
    const Interval mean = sample.mean_interval(0.95), p95 = sample.quantile_interval(0.95, 0.95);
    return std::vector{sample.moments().mean,
                       sample.moments().sd,
                       sample.quantile(0.95).value,
                       mean.lower,
                       mean.upper,
                       p95.lower,
                       p95.upper,
                       p95.design_effect};
  };
  for (const std::uint64_t rocks : {1, 20}) CHECK(numbers(0.1, rocks) == numbers(1, rocks));
}

TEST_CASE("Rocks of unequal weights say as much as Kish's number of equal ones") {
  // One rock a trial, weights 1 and 3: n sum w^2 / (sum w)^2 = 5 / 4.
  ShareTally tally;
  for (std::uint64_t t = 0; t < 4000; ++t) {
    tally.add(t, t % 2 == 0 ? 1 : 3);
    if (t % 20 < 2) tally.count();
  }
  tally.close();
  const Share share = tally.of_rocks();
  CHECK(share.value == Approx(0.1).epsilon(1e-12));
  CHECK(share.interval.design_effect == Approx(1.25).epsilon(1e-3));
}

TEST_CASE("Intervals of weighted samples contain the truth in 92 to 99 % of runs", "[slow]") {
  using namespace weighted_samples;
  const double p95 = TwoGroups::quantile(0.95);
  for (const auto& [trials, rocks] : {std::pair{800, 1}, {200, 10}}) {
    constexpr int seeds = 400;
    int of_mean = 0, of_p95 = 0, of_share = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const TwoGroups groups(seed, trials, rocks);
      const Sample sample = groups.sample();
      of_mean += design_effects::holds(sample.mean_interval(0.95), TwoGroups::mean());
      of_p95 += design_effects::holds(sample.quantile_interval(0.95, 0.95), p95);
      of_share += design_effects::holds(groups.share_above(p95).interval, 0.05);
    }
    INFO(trials << " trials of " << rocks << " rocks: " << of_mean << ", " << of_p95 << ", " << of_share);
    for (const int held : {of_mean, of_p95, of_share}) {
      CHECK(held >= 0.92 * seeds);
      CHECK(held <= 0.99 * seeds);
    }
  }
}
