// Intervals of shares against published and closed values.

#include "results/statistics/share.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

TEST_CASE("the interval of a share is that of Clopper and Pearson") {
  // R: binom.test(15, 100), binom.test(1, 20).
  CHECK(share_interval(15, 100, 0.95).lower == Approx(0.08645439).epsilon(1e-6));
  CHECK(share_interval(15, 100, 0.95).upper == Approx(0.2353075).epsilon(1e-6));
  CHECK(share_interval(1, 20, 0.95).lower == Approx(0.001265089).epsilon(1e-6));
  CHECK(share_interval(1, 20, 0.95).upper == Approx(0.2487328).epsilon(1e-6));
}

TEST_CASE("none of n has an upper end, and all of n a lower one") {
  for (const std::uint64_t n : {1, 10, 1000}) {
    const double end = 1 - std::pow(0.025, 1.0 / static_cast<double>(n));
    CHECK(share_interval(0, n, 0.95).lower == 0);
    CHECK(share_interval(0, n, 0.95).upper == Approx(end));
    CHECK(share_interval(n, n, 0.95).lower == Approx(1 - end));
    CHECK(share_interval(n, n, 0.95).upper == 1);
  }
  CHECK(std::isnan(share_interval(0, 0, 0.95).upper));
  CHECK(std::isnan(share_of(0, 0).value));
}

TEST_CASE("of a share that may still grow the upper end is that of all who may yet count") {
  const Share share = share_of(3, 10, 2);
  CHECK(share.value == Approx(0.3));
  CHECK(share.censored);
  CHECK(share.interval.lower == share_interval(3, 10, 0.95).lower);
  CHECK(share.interval.upper == share_interval(5, 10, 0.95).upper);
  CHECK_FALSE(share_of(3, 10).censored);
}
