// Greatest throws of a model beside measured ones.

#include "results/compare/throws.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

namespace flyrock::throws_test {

namespace {

/// Measured throws are a lognormal factor times those of the model: its median, and the deviation of its log.
std::vector<Throw> blasts(int count, double median, double sd, std::uint64_t seed = 5) {
  RandomStream rng(seed, "throws", {});
  std::vector<Throw> list;
  for (int i = 0; i < count; ++i) {
    const double model = 50 + 200 * rng.uniform();
    list.push_back({model * median * std::exp(sd * rng.normal()), model});
  }
  return list;
}

}  // namespace

TEST_CASE("throws that are twice the model's are all short, and the factor 2 covers them") {
  const ThrowSummary summary = summary_of(blasts(40, 2, 0));
  CHECK(summary.blasts == 40);
  CHECK(summary.short_of.value == 1);
  for (const CoveringFactor& factor : summary.factors) CHECK(factor.factor == Approx(2));
  CHECK(summary.rank.r == 1);
  REQUIRE(summary.site);
  CHECK(summary.site->factor == Approx(2));
  CHECK(summary.site->fitted == 20);
  CHECK(summary.site->judged == 20);
}

TEST_CASE("covering factors are quantiles of the ratio, with intervals that hold them") {
  const double median = 1.5, sd = 0.5;
  const auto quantile = [&](double z) { return median * std::exp(sd * z); };
  const ThrowSummary many = summary_of(blasts(20'000, median, sd));
  CHECK(many.factors[0].factor == Approx(quantile(0)).epsilon(0.02));
  CHECK(many.factors[1].factor == Approx(quantile(1.6448536)).epsilon(0.03));
  CHECK(many.factors[2].factor == Approx(quantile(2.3263479)).epsilon(0.04));
  // P(median exp(sd z) > 1) with z normal
  CHECK(many.short_of.value ==
        Approx(0.5 * std::erfc(-std::log(median) / sd / std::sqrt(2.0))).epsilon(0.02));
  int held = 0;
  constexpr int studies = 200;
  for (std::uint64_t s = 0; s < studies; ++s) {
    const Interval interval = summary_of(blasts(300, median, sd, s)).factors[1].interval;
    held += interval.lower <= quantile(1.6448536) && quantile(1.6448536) <= interval.upper;
  }
  CHECK(held >= 0.92 * studies);
}

TEST_CASE("a factor made to cover 95 % of half of the blasts covers about as many of the others") {
  double covered = 0;
  constexpr int studies = 200;
  for (std::uint64_t s = 0; s < studies; ++s)
    covered += summary_of(blasts(264, 3, 0.7, s)).site->covered.value;
  CHECK(covered / studies == Approx(0.95).margin(0.015));
}

TEST_CASE("few blasts have no factor of the site, none have nothing") {
  CHECK_FALSE(summary_of(blasts(19, 1, 0.2)).site);
  CHECK(summary_of({}).blasts == 0);
  CHECK(std::isnan(summary_of(blasts(5, 1, 0.2)).factors[2].interval.upper));
}

}  // namespace flyrock::throws_test
