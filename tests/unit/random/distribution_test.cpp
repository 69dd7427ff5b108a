#include "random/distribution.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

Distribution make(DistributionKind kind, double a, double b = 0, double c = 0, double d = 0) {
  Distribution f;
  f.kind = kind;
  f.a = a;
  f.b = b;
  f.c = c;
  f.d = d;
  return f;
}

Distribution sieve() {
  Distribution f = make(DistributionKind::sieve, 0);
  f.values = {0.1, 0.2, 0.5, 1.2};
  f.weights = {0, 0.1, 0.8, 1};
  return f;
}

std::vector<Distribution> continuous() {
  return {make(DistributionKind::uniform, 2, 5),          make(DistributionKind::normal, 3, 2),
          make(DistributionKind::lognormal, 0.6, 0.35),   make(DistributionKind::triangular, 1, 2, 6),
          make(DistributionKind::weibull, 1.5, 2.2),      make(DistributionKind::beta, 2, 5, -1, 4),
          make(DistributionKind::exponential, 0.8),       make(DistributionKind::rosin_rammler, 0.3, 1.1),
          make(DistributionKind::power_law, 0.1, 3, 2.5), sieve()};
}

}  // namespace

TEST_CASE("the quantile is the inverse of the cumulative distribution") {
  for (const Distribution& f : continuous()) {
    INFO(name_of(f.kind));
    REQUIRE(f.fault().empty());
    for (double u : {0.001, 0.1, 0.3, 0.5, 0.9, 0.999})
      CHECK(f.cumulative(f.quantile(u)) == Approx(u).epsilon(1e-9));
  }
}

TEST_CASE("medians in closed form") {
  CHECK(make(DistributionKind::uniform, 2, 5).quantile(0.5) == Approx(3.5));
  CHECK(make(DistributionKind::normal, 3, 2).quantile(0.5) == Approx(3));
  CHECK(make(DistributionKind::normal, 3, 2).quantile(0.975) == Approx(3 + 2 * 1.959963984540054));
  CHECK(make(DistributionKind::lognormal, 0.6, 0.35).quantile(0.5) == Approx(0.6));
  CHECK(make(DistributionKind::weibull, 1.5, 2.2).quantile(0.5) ==
        Approx(1.5 * std::pow(std::log(2), 1 / 2.2)));
  CHECK(make(DistributionKind::exponential, 0.8).quantile(0.5) == Approx(0.8 * std::log(2)));
  CHECK(make(DistributionKind::triangular, 0, 1, 2).quantile(0.5) == Approx(1));
  CHECK(make(DistributionKind::beta, 2, 2, 0, 4).quantile(0.5) == Approx(2));
  CHECK(make(DistributionKind::rosin_rammler, 0.3, 1.1).quantile(0.5) == Approx(0.3));
  // Half of 1 - (0.1 / x)^2.5, of which all but 30^-2.5 is kept
  CHECK(make(DistributionKind::power_law, 0.1, 3, 2.5).quantile(0.5) ==
        Approx(0.1 * std::pow(1 - 0.5 * (1 - std::pow(30, -2.5)), -0.4)));
  // 4/7 of the way in ln x from 0.2 to 0.5
  CHECK(sieve().quantile(0.5) == Approx(0.2 * std::pow(2.5, 4.0 / 7)));
}

TEST_CASE("truncation is exact: the truncated quantile in terms of the whole") {
  for (Distribution f : continuous()) {
    INFO(name_of(f.kind));
    const double low = f.quantile(0.2), high = f.quantile(0.7), at = f.quantile(0.2 + 0.4 * 0.5);
    f.min = low;
    f.max = high;
    REQUIRE(f.fault().empty());
    CHECK(f.quantile(0.4) == Approx(at));
    CHECK(f.quantile(1e-12) >= low);
    CHECK(f.quantile(1 - 1e-12) <= high);
    CHECK(f.lowest() == low);
    CHECK(f.highest() == high);
  }
}

TEST_CASE("discrete and integer distributions") {
  Distribution f = make(DistributionKind::discrete, 0);
  f.values = {5, 1, 3};
  CHECK(f.quantile(0.1) == 5);
  CHECK(f.quantile(0.5) == 1);
  CHECK(f.quantile(0.9) == 3);
  f.weights = {1, 0, 3};
  CHECK(f.quantile(0.24) == 5);
  CHECK(f.quantile(0.26) == 3);
  CHECK(f.lowest() == 3);
  f.max = 4;
  CHECK(f.quantile(0.01) == 3);

  const Distribution sides = make(DistributionKind::integer, 5, 9);
  CHECK(sides.quantile(1e-9) == 5);
  CHECK(sides.quantile(0.5) == 7);
  CHECK(sides.quantile(1 - 1e-9) == 9);
  CHECK(sides.cumulative(5) == Approx(0.2));
}

TEST_CASE("faults of distributions") {
  CHECK(make(DistributionKind::uniform, 5, 2).fault() == "its low end must be below its high end");
  CHECK(make(DistributionKind::normal, 5, 0).fault() == "its sd must be above 0");
  CHECK(make(DistributionKind::integer, 1.5, 3).fault() == "its ends must be whole numbers");
  Distribution f = make(DistributionKind::normal, 0, 1);
  f.min = 1;
  f.max = 1;
  CHECK(f.fault() == "its min must be below its max");
  f.min = 20;
  f.max = 30;
  CHECK(f.fault() == "less than 1e-9 of it lies between its min and its max");
  f = make(DistributionKind::uniform, 0, 1);
  f.min = 2;
  CHECK(f.fault() == "nothing of it lies between its min and its max");
  f = make(DistributionKind::discrete, 0);
  CHECK_FALSE(f.fault().empty());
  f = sieve();
  f.weights[1] = 0.9;
  CHECK(f.fault() == "its shares must rise");
  CHECK(make(DistributionKind::power_law, 2, 1, 1).fault() ==
        "its low end must be above 0 and below its high end");
}

TEST_CASE("a draw depends on the parts of the key that its scope names") {
  const std::uint64_t seed = 7;
  const DrawKey key{3, 2, 5, 4};
  struct Case {
    Scope scope;
    bool trial, hole, rock, impact;
  };
  for (const Case& c :
       {Case{Scope::run, false, false, false, false}, Case{Scope::trial, true, false, false, false},
        Case{Scope::hole, true, true, false, false}, Case{Scope::rock, true, false, true, false},
        Case{Scope::impact, true, false, true, true}}) {
    Draw draw;
    draw.stream = "blast.burden";
    draw.stream_hash = hash_name(draw.stream);
    draw.distribution = make(DistributionKind::uniform, 0, 1);
    draw.scope = c.scope;
    const double value = draw.value(seed, key);
    INFO(name_of(c.scope));
    CHECK(draw.value(seed, key) == value);
    CHECK(draw.value(seed + 1, key) != value);
    CHECK((draw.value(seed, {4, 2, 5, 4}) != value) == c.trial);
    CHECK((draw.value(seed, {3, 3, 5, 4}) != value) == c.hole);
    CHECK((draw.value(seed, {3, 2, 6, 4}) != value) == c.rock);
    CHECK((draw.value(seed, {3, 2, 5, 5}) != value) == c.impact);
  }
}

TEST_CASE("the share below a value is that of the draws, and negligible tails end where it is 1e-9") {
  for (Distribution f : continuous()) {
    INFO(name_of(f.kind));
    f.min = f.quantile(0.1);
    f.max = f.quantile(0.8);
    for (const double u : {0.01, 0.25, 0.5, 0.99}) CHECK(f.share_below(f.quantile(u)) == Approx(u));
    CHECK(f.share_below(f.min) == 0);
    CHECK(f.share_below(f.max) == 1);
    CHECK(f.likely_lowest() == f.lowest());
    CHECK(f.likely_highest() == f.highest());
  }
  const Distribution normal = make(DistributionKind::normal, 3, 2);
  CHECK(normal.share_below(normal.likely_lowest()) == Approx(1e-9));
  CHECK(1 - normal.share_below(normal.likely_highest()) == Approx(1e-9).epsilon(1e-6));
}
