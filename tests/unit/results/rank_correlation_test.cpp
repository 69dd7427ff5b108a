#include "results/rank_correlation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

using namespace flyrock;

TEST_CASE("Rank correlation of small samples is that of the textbooks") {
  // No ties: 1 - 6 sum d^2 / (n (n^2 - 1)); here d = (0, 1, 1, 1, 1), so 1 - 24 / 120.
  CHECK(rank_correlation({1, 2, 3, 4, 5}, {1, 3, 2, 5, 4}, 0.95).r == Approx(0.8));
  // Any rising function keeps the ranks.
  CHECK(rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1000}, 0.95).r == 1);
  CHECK(rank_correlation({1, 2, 3, 4}, {8, 4, 2, 1}, 0.95).r == -1);
  // Ties take the mean of their ranks: Pearson of (1, 2.5, 2.5, 4) and (1, 2, 3, 4).
  CHECK(rank_correlation({1, 2, 2, 3}, {1, 2, 3, 4}, 0.95).r == Approx(std::sqrt(0.9)));
  CHECK(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3}, 0.95).r));
  CHECK(std::isnan(rank_correlation({1, 2, 3}, {1, 2, 3}, 0.95).lower));
}

TEST_CASE("The interval of a rank correlation holds the true one as often as stated") {
  // Two normal numbers of correlation rho have the rank correlation (6 / pi) asin(rho / 2).
  const double rho = 0.5, truth = 6 / M_PI * std::asin(rho / 2);
  int held = 0;
  constexpr int samples = 2000;
  for (int s = 0; s < samples; ++s) {
    RandomStream rng(11, "rank correlation", {.trial = static_cast<std::uint64_t>(s)});
    std::vector<double> a, b;
    for (int i = 0; i < 50; ++i) {
      a.push_back(rng.normal());
      b.push_back(rho * a.back() + std::sqrt(1 - rho * rho) * rng.normal());
    }
    const RankCorrelation found = rank_correlation(a, b, 0.95);
    held += found.lower <= truth && truth <= found.upper;
  }
  CHECK(held > 0.935 * samples);
  CHECK(held < 0.965 * samples);
}
