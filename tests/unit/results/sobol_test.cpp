// Sobol's indices of functions whose indices are known.

#include "results/statistics/sobol.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numeric>

#include "random/sampling.h"
#include "results/statistics/input_response.h"

using namespace flyrock;

namespace sobol_test {

namespace {

using Function = std::function<double(const std::vector<double>&)>;

struct KnownIndices {
  Function f;
  std::vector<double> first, total;
};

KnownIndices ishigami(double shift) {
  const auto f = [shift](const std::vector<double>& u) {
    const auto x = [&](std::size_t i) { return M_PI * (2 * u[i] - 1); };
    return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0)) +
           shift;
  };
  return {f, {0.31390519, 0.44241114, 0}, {0.55758886, 0.44241114, 0.24368366}};
}

/// Sobol's g with 8 inputs: the product of (|4 u - 2| + a) / (1 + a).
KnownIndices sobol_g() {
  const std::vector<double> a{0, 1, 4.5, 9, 99, 99, 99, 99};
  const auto f = [a](const std::vector<double>& u) {
    double product = 1;
    for (std::size_t i = 0; i < a.size(); ++i) product *= (std::abs(4 * u[i] - 2) + a[i]) / (1 + a[i]);
    return product;
  };
  KnownIndices known{f, {}, {}};
  const auto part = [&](std::size_t i) { return 1 / (3 * (1 + a[i]) * (1 + a[i])); };
  double variance = 1;
  for (std::size_t i = 0; i < a.size(); ++i) variance *= 1 + part(i);
  variance -= 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double with_others = part(i);
    for (std::size_t j = 0; j < a.size(); ++j)
      if (j != i) with_others *= 1 + part(j);
    known.first.push_back(part(i) / variance);
    known.total.push_back(with_others / variance);
  }
  return known;
}

/// The runs of a function of uniform numbers, each of a stream of its own.
ExchangedRuns runs_of(const Function& f, std::size_t inputs, std::size_t trials, std::uint64_t seed,
                      Sampling sampling = Sampling::random) {
  std::vector<std::uint64_t> names;
  for (std::size_t i = 0; i < inputs; ++i) names.push_back(hash_name("input " + std::to_string(i)));
  ExchangedRuns runs;
  runs.ab.resize(inputs);
  Exchange exchange{.seed = seed + 1'000'000};
  Streams streams(seed);
  streams.sampling = sampling;
  streams.trials = trials;
  streams.dimensions = static_cast<int>(inputs);
  streams.exchange = &exchange;
  const auto value = [&](std::size_t trial) {
    std::vector<double> u;
    for (std::size_t i = 0; i < inputs; ++i)
      u.push_back(sampling == Sampling::random
                      ? uniform_at(streams.seed_of(names[i]), names[i], {.trial = trial})
                      : sampled_at(streams, names[i], static_cast<int>(i), trial));
    return f(u);
  };
  for (std::size_t trial = 0; trial < trials; ++trial) {
    exchange = {.seed = exchange.seed};
    runs.a.push_back(value(trial));
    exchange.all_but = true;
    runs.b.push_back(value(trial));
    exchange.all_but = false;
    for (std::size_t i = 0; i < inputs; ++i) {
      exchange.names = {names[i]};
      runs.ab[i].push_back(value(trial));
    }
  }
  return runs;
}

bool holds(const Interval& interval, double value) {
  return interval.lower <= value && value <= interval.upper;
}

/// In how many of 100 seeds each index lies in its interval: the first orders, then the totals.
std::vector<int> coverage(const KnownIndices& known, Sampling sampling = Sampling::random) {
  constexpr int seeds = 100, bootstraps = 200;
  const std::size_t inputs = known.first.size();
  std::vector<int> inside(2 * inputs, 0);
  for (int seed = 1; seed <= seeds; ++seed) {
    const SobolIndices found =
        sobol_indices(runs_of(known.f, inputs, 1024, static_cast<std::uint64_t>(seed), sampling),
                      static_cast<std::uint64_t>(seed), bootstraps);
    for (std::size_t i = 0; i < inputs; ++i) {
      inside[i] += holds(found.inputs[i].first_interval, known.first[i]);
      inside[inputs + i] += holds(found.inputs[i].total_interval, known.total[i]);
    }
  }
  return inside;
}

void check_coverage(const std::vector<int>& inside) {
  for (const int count : inside) {
    CHECK(count >= 88);
    CHECK(count <= 100);
  }
  const double mean = std::accumulate(inside.begin(), inside.end(), 0.0) / static_cast<double>(inside.size());
  CHECK(mean >= 92);  // 95 %, with the error of 100 seeds
  CHECK(mean <= 98);
}

}  // namespace

TEST_CASE("the indices of Ishigami's function lie in their intervals as often as these say", "[slow]") {
  check_coverage(coverage(ishigami(0)));
}

TEST_CASE("a great mean changes no index") {
  const ExchangedRuns plain = runs_of(ishigami(0).f, 3, 512, 3),
                      shifted = runs_of(ishigami(100).f, 3, 512, 3);
  const SobolIndices a = sobol_indices(plain, 1), b = sobol_indices(shifted, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(b.inputs[i].first == Approx(a.inputs[i].first).epsilon(1e-9));
    CHECK(b.inputs[i].total_interval.upper == Approx(a.inputs[i].total_interval.upper).epsilon(1e-9));
  }
}

TEST_CASE("the indices of Sobol's g with 8 inputs lie in their intervals as often as these say", "[slow]") {
  check_coverage(coverage(sobol_g()));
}

TEST_CASE("with Sobol's points the intervals hold the indices at least as often", "[slow]") {
  for (const int count : coverage(ishigami(0), Sampling::sobol)) CHECK(count >= 93);
}

TEST_CASE("a product of powers of lognormal numbers has the indices of its closed form") {
  // Richards and Moore: L ~ (sqrt(m) / B)^2.6 k^2. ln f is a sum, so with s_i = p_i sigma_i the first order
  // is (exp(s_i^2) - 1) / (exp(sum s^2) - 1), and the total exp(sum of the others) (exp(s_i^2) - 1) over the
  // same.
  const std::vector<double> s{1.3 * 0.1, 2.6 * 0.12, 2 * 0.15};
  Distribution normal;
  normal.kind = DistributionKind::normal;
  normal.b = 1;
  const auto f = [&](const std::vector<double>& u) {
    double sum = 0;
    for (std::size_t i = 0; i < s.size(); ++i) sum += s[i] * normal.quantile(u[i]);
    return 200 * std::exp(sum);
  };
  const double all = std::exp(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
  const SobolIndices found = sobol_indices(runs_of(f, 3, 4096, 8), 2);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double own = std::exp(s[i] * s[i]);
    INFO(i);
    CHECK(holds(found.inputs[i].first_interval, (own - 1) / (all - 1)));
    CHECK(holds(found.inputs[i].total_interval, all / own * (own - 1) / (all - 1)));
  }
  CHECK(found.sum_first <= 1.05);
}

TEST_CASE("a trial without a number in one run is left out of all runs") {
  ExchangedRuns runs = runs_of(ishigami(0).f, 3, 1000, 5);
  runs.ab[2][17] = unknown;
  runs.b[3] = unknown;
  const SobolIndices found = sobol_indices(runs, 1);
  CHECK(found.trials == 998);
  CHECK(found.left_out == 2);
  CHECK_FALSE(found.is_lost());
  CHECK(std::isfinite(found.inputs[0].first));
  for (std::size_t t = 0; t < 60; ++t) runs.a[t] = unknown;
  const SobolIndices lost = sobol_indices(runs, 1);
  CHECK(lost.is_lost());
  CHECK(std::isnan(lost.inputs[0].first));
}

TEST_CASE("a number that nothing moves has no indices, and an input that moves nothing has 0") {
  const SobolIndices constant = sobol_indices(runs_of([](const auto&) { return 217.3; }, 2, 100, 1), 1);
  CHECK(std::isnan(constant.sum_first));
  const SobolIndices one = sobol_indices(runs_of([](const auto& u) { return u[0]; }, 2, 100, 1), 1);
  CHECK(one.inputs[1].total == 0);
  CHECK(one.inputs[1].first == 0);
  CHECK(one.inputs[0].total > 0.7);
}

TEST_CASE("a response has the mean about p10 and p90, and crosses a line where the function does") {
  std::vector<double> x, f;
  for (std::uint64_t t = 0; t < 4000; ++t) {
    x.push_back(uniform_at(1, 1, {.trial = t}));
    f.push_back(uniform_at(1, 2, {.trial = t}) > x.back() ? 1 : 0);  // the mean is 1 - x
  }
  const auto response = response_of(x, f);
  REQUIRE(response);
  CHECK(response->p10 == Approx(0.1).margin(0.02));
  CHECK(response->f_p10 == Approx(0.9).margin(0.05));
  CHECK(response->f_p90 == Approx(0.1).margin(0.05));
  CHECK(response->curve.size() == 10);
  const auto crossing = crossing_of(x, f, 0.3, 7, 100);
  REQUIRE(crossing);
  CHECK_FALSE(crossing->is_rising);
  CHECK(holds(crossing->interval, 0.7));
  CHECK(crossing->at == Approx(0.7).margin(0.06));
  CHECK_FALSE(crossing_of(x, f, 1.5, 7, 100));
  CHECK_FALSE(response_of(std::vector<double>(100, 2.0), std::vector<double>(100, 1.0)));
}

TEST_CASE("the parts of a curve have intervals of their percentiles, where the trials give them") {
  int held = 0, parts = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    std::vector<double> x, f;
    for (std::uint64_t t = 0; t < 1000; ++t) {
      x.push_back(uniform_at(seed, 1, {.trial = t}));
      f.push_back(uniform_at(seed, 2, {.trial = t}));
    }
    const auto response = response_of(x, f);
    for (const ResponseBin& bin : response->curve) {
      ++parts;
      held += holds(bin.p95_interval, 0.95);
      CHECK(holds(bin.p50_interval, bin.p50));
      CHECK(std::isnan(bin.p99_interval.upper));  // 0.99^100 > 0.025
    }
  }
  CHECK(parts == 300);
  CHECK(held >= 280);  // at least 95 % of them: 285 +- 4
}

}  // namespace sobol_test
