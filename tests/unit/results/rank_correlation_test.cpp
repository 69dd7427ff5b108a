#include "results/statistics/rank_correlation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

using namespace flyrock;

namespace {

/// Each pair is of a trial of its own.
PairUnits alone(std::size_t pairs) {
  PairUnits units;
  for (std::size_t i = 0; i < pairs; ++i) units.add(i, 1);
  return units;
}

double r_of(const std::vector<double>& a, const std::vector<double>& b) {
  return rank_correlation(a, b, alone(a.size())).r;
}

/// Two normal numbers of correlation rho have this rank correlation.
double of_normals(double rho) { return 6 / M_PI * std::asin(rho / 2); }

}  // namespace

TEST_CASE("Rank correlation of small samples is that of the textbooks") {
  // No ties: 1 - 6 sum d^2 / (n (n^2 - 1)); here d = (0, 1, 1, 1, 1), so 1 - 24 / 120.
  CHECK(r_of({1, 2, 3, 4, 5}, {1, 3, 2, 5, 4}) == Approx(0.8));
  // Any rising function keeps the ranks.
  CHECK(r_of({1, 2, 3, 4}, {1, 10, 100, 1000}) == 1);
  CHECK(r_of({1, 2, 3, 4}, {8, 4, 2, 1}) == -1);
  // Ties take the mean of their ranks: Pearson of (1, 2.5, 2.5, 4) and (1, 2, 3, 4).
  CHECK(r_of({1, 2, 2, 3}, {1, 2, 3, 4}) == Approx(std::sqrt(0.9)));
  CHECK(std::isnan(r_of({1, 1, 1}, {1, 2, 3})));
  CHECK(std::isnan(rank_correlation({1, 2, 3}, {1, 2, 3}, alone(3)).interval(0.95).lower));
}

TEST_CASE("The interval of a rank correlation holds the true one as often as stated") {
  const double rho = 0.5, truth = of_normals(rho);
  int held = 0;
  constexpr int samples = 2000;
  for (int s = 0; s < samples; ++s) {
    RandomStream rng(11, "rank correlation", {.trial = static_cast<std::uint64_t>(s)});
    std::vector<double> a, b;
    for (int i = 0; i < 50; ++i) {
      a.push_back(rng.normal());
      b.push_back(rho * a.back() + std::sqrt(1 - rho * rho) * rng.normal());
    }
    const RankCorrelation correlation = rank_correlation(a, b, alone(a.size()));
    CHECK(correlation.effective_size == Approx(50));
    const Interval found = correlation.interval(0.95);
    held += found.lower <= truth && truth <= found.upper;
  }
  CHECK(held > 0.935 * samples);
  CHECK(held < 0.965 * samples);
}

TEST_CASE("Where rocks share the draws of their trial, the interval takes the trial as its unit", "[slow]") {
  // The first number is one draw a trial; of the second a part is the trial's own, the rest the rock's.
  constexpr int studies = 400, trials = 60;
  const double rho = GENERATE(0.0, 0.6);
  const int rocks = GENERATE(20, 200);
  const double of_trial = 0.6, of_rock = std::sqrt(1 - rho * rho - of_trial * of_trial);
  const double truth = of_normals(rho);
  int held = 0, held_by_rocks = 0;
  for (int s = 0; s < studies; ++s) {
    RandomStream rng(12, "rank correlation", {.trial = static_cast<std::uint64_t>(s)});
    std::vector<double> a, b;
    PairUnits units;
    for (std::uint64_t t = 0; t < trials; ++t) {
      const double shared = rng.normal(), own = rng.normal();
      for (int i = 0; i < rocks; ++i) {
        units.add(t, 1);
        a.push_back(shared);
        b.push_back(rho * shared + of_trial * own + of_rock * rng.normal());
      }
    }
    const auto holds = [&](const Interval& interval) {
      return interval.lower <= truth && truth <= interval.upper;
    };
    held += holds(rank_correlation(a, b, units).interval(0.95));
    held_by_rocks += holds(rank_correlation(a, b, alone(a.size())).interval(0.95));
  }
  INFO("rho " << rho << ", " << rocks << " rocks a trial: " << held << " of " << studies);
  CHECK(held >= 0.92 * studies);
  CHECK(held <= 0.99 * studies);
  CHECK(held_by_rocks < 0.6 * studies);
}

TEST_CASE("A weight of a pair counts as that many equal pairs") {
  const std::vector<double> a{1, 5, 2, 4, 3, 6}, b{2, 1, 4, 4, 3, 7};
  const std::vector<int> weight{1, 3, 2, 1, 1, 2};
  PairUnits weighted, repeated;
  std::vector<double> all_a, all_b;
  for (std::size_t i = 0; i < a.size(); ++i) {
    weighted.add(i, weight[i]);
    for (int k = 0; k < weight[i]; ++k) {
      repeated.add(i, 1);
      all_a.push_back(a[i]);
      all_b.push_back(b[i]);
    }
  }
  const RankCorrelation one = rank_correlation(a, b, weighted),
                        other = rank_correlation(all_a, all_b, repeated);
  CHECK(one.r == Approx(other.r));
  CHECK(one.effective_size == Approx(other.effective_size));
  CHECK(one.trials == other.trials);
}
