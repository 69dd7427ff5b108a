// Bounds of the probability per blast of rocks that stand for several real ones.

#include "results/statistics/blast_bounds.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numeric>

#include "random/stream.h"
#include "results/measured/crossing_summary.h"

using namespace flyrock;

namespace blast_bounds_test {

WeightRange weights_of(std::initializer_list<double> weights) {
  WeightRange range;
  for (const double weight : weights) range.add(weight);
  return range;
}

/// k of m trials have a rock that passes a gate.
SimulatedBlasts at_gate(std::uint64_t k, std::uint64_t m, const WeightRange& weights) {
  const Share share = share_of(k, m);
  return {share.value, share.interval, share.value, share.interval, weights, weights};
}

BlastBounds of_share(double share, double weight) {
  const WeightRange weights = weights_of({weight});
  return bounds_of({share, {share, share}, share, {share, share}, weights, weights});
}

TEST_CASE("Bounds of rocks that pass a gate are those computed by hand") {
  // 100 rocks of weight 2, each past the gate with the probability 0.0138.
  const double share = 1 - std::pow(1 - 0.0138, 100);
  const BlastBounds many = of_share(share, 2);
  CHECK(share == Approx(0.751).epsilon(1e-3));
  CHECK(many.lower == share);
  CHECK(many.upper == Approx(0.938).epsilon(1e-3));
  CHECK(many.upper / many.lower == Approx(2 - share));
  // One rock of weight 2 with the probability 0.7.
  CHECK(of_share(0.7, 2).upper == Approx(0.91).epsilon(1e-12));
  // 2 rocks of weight 100 say what 200 rocks do, where they share nothing.
  CHECK(of_share(1 - std::pow(1 - 0.0138, 2), 100).upper == Approx(1 - std::pow(1 - 0.0138, 200)));
}

TEST_CASE("With the weight 1 the bounds are the share and its exact interval, to the digit") {
  for (const std::uint64_t k : {0u, 3u, 77u, 200u}) {
    const Share share = share_of(k, 200);
    const BlastBounds bounds = bounds_of(at_gate(k, 200, weights_of({1})));
    CHECK(bounds.lower == share.value);
    CHECK(bounds.upper == share.value);
    CHECK(bounds.interval.lower == share.interval.lower);
    CHECK(bounds.interval.upper == share.interval.upper);
    CHECK(bounds.tells());
  }
}

TEST_CASE("Below the weight 1 the bounds change places") {
  // Of 40 % of the trials in which a rock passes, half a rock is real.
  const BlastBounds bounds = of_share(0.4, 0.5);
  CHECK(bounds.upper == 0.4);
  CHECK(bounds.lower == Approx(1 - std::sqrt(0.6)));
  CHECK(telling_weight(bounds) == 1);
}

TEST_CASE("Of groups with different weights U is the less of the heaviest and of their sum") {
  const auto bounds_of_both = [](double light, double heavy) {
    const double both = 1 - (1 - light) * (1 - heavy);
    const std::vector<BlastBounds> groups{of_share(light, 2), of_share(heavy, 20)};
    return over_groups(of_share(both, 20), groups);
  };
  const BlastBounds sum = bounds_of_both(0.3, 0.001);
  CHECK(sum.upper == Approx(0.51 + 1 - std::pow(0.999, 20)));
  CHECK(sum.lower == 0.3);
  const BlastBounds heaviest = bounds_of_both(0.01, 0.3);
  CHECK(heaviest.upper == Approx(1 - std::pow(0.99 * 0.7, 20)));
  CHECK(heaviest.lower == 0.3);
}

TEST_CASE("The weight that tells brings the bounds to within 1.2 of each other, whatever rocks share") {
  for (const double weight : {2.0, 10.0, 100.0})
    for (const double share : {1e-4, 0.01, 0.2, 0.6}) {
      const BlastBounds bounds = of_share(share, weight);
      if (bounds.tells()) continue;
      const double n = telling_weight(bounds);
      INFO(weight << " " << share << " " << n);
      CHECK(n >= 1.2);
      CHECK(n < weight);
      // The truth is L where rocks share all, and U where they share nothing: n times as few rocks then miss.
      const double shared = bounds.lower, alone = 1 - std::pow(1 - bounds.upper, 1 / n);
      for (const double simulated : {shared, alone}) CHECK(carried(simulated, n) <= 1.21 * simulated);
    }
}

/// A blast by its random numbers: how many of its simulated rocks pass, by group.
using Blast = std::function<std::vector<int>(RandomStream&)>;

/// The interval of gates over trials, from the tally of a run.
Interval interval_of(const Blast& blast, const std::vector<double>& weights, int trials, std::uint64_t seed) {
  Scenario scenario;
  scenario.gates = {{.name = "gate", .x = 0}};
  scenario.rocks.resize(weights.size());
  TrialRecords records;
  for (int t = 0; t < trials; ++t) {
    RandomStream rng(seed, "blasts", DrawKey{.trial = static_cast<std::uint64_t>(t)});
    const std::vector<int> passes = blast(rng);
    int number = 0;
    for (std::size_t g = 0; g < weights.size(); ++g)
      for (int i = 0; i <= passes[g]; ++i) {  // one rock of each group stays
        RockRecord& rock = records.rocks.emplace_back();
        rock.trial = static_cast<std::uint64_t>(t);
        rock.rock = number;
        rock.group = static_cast<int>(g);
        rock.weight = weights[g];
        rock.reason = StopReason::stopped;
        if (i > 0) records.gates.push_back({rock.trial, number, {{0, 1, 1, 1, 0}, 0}});
        ++number;
      }
  }
  CrossingTallies tally(scenario);
  do tally.add(records);
  while (tally.needs_another_pass());
  return tally.summaries().front().gates.front().shares.per_trial.interval;
}

/// The number of n that do something with the probability p.
int binomial(RandomStream& rng, int n, double p) {
  int k = 0;
  for (int i = 0; i < n; ++i) k += rng.uniform() < p;
  return k;
}

TEST_CASE("In at least 92 of 100 runs the interval holds the truth, whatever the rocks of a blast share",
          "[slow]") {
  struct Case {
    const char* name;
    std::vector<double> weights;
    Blast blast;
    double truth;
  };
  const int steps = 2000;  // of the mean over the shared burden
  double burden = 0;
  for (int i = 0; i < steps; ++i) burden += (1 - std::pow(1 - 0.02 * (i + 0.5) / steps, 100)) / steps;
  const Case cases[] = {
      {"alone",
       {2},
       [](RandomStream& rng) { return std::vector{binomial(rng, 100, 0.0138)}; },
       1 - std::pow(1 - 0.0138, 200)},
      {"one rock", {2}, [](RandomStream& rng) { return std::vector{binomial(rng, 1, 0.7)}; }, 0.91},
      {"a branch of 2 %",
       {10},
       [](RandomStream& rng) { return std::vector{rng.uniform() < 0.02 ? binomial(rng, 20, 0.1) : 0}; },
       0.02 * (1 - std::pow(0.9, 200))},
      {"a shared burden",
       {10},
       [](RandomStream& rng) {
         const double p = 0.02 * rng.uniform();
         return std::vector{binomial(rng, 10, p)};
       },
       burden},
      {"two groups",
       {1, 20},
       [](RandomStream& rng) {
         return std::vector{binomial(rng, 5, 0.03), binomial(rng, 2, 0.002)};
       },
       1 - std::pow(0.97, 5) * std::pow(0.998, 40)}};
  for (const Case& each : cases) {
    INFO(each.name);
    int held = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const Interval interval = interval_of(each.blast, each.weights, 300, seed);
      held += interval.lower <= each.truth && each.truth <= interval.upper;
    }
    CHECK(held >= 92);
  }
}

}  // namespace blast_bounds_test
