// Samplers of sizes against their distributions, by the chi-square of counts in cells.

#include <boost/math/distributions/chi_squared.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "random/pieces_by_mass.h"
#include "random/stream.h"

using namespace flyrock;

namespace goodness_of_fit_test {

constexpr int draws = 100'000, cells = 50;

std::vector<double> sample_from(const Distribution& distribution, std::uint64_t seed) {
  RandomStream rng(seed, "sizes", DrawKey{});
  std::vector<double> sizes;
  for (int i = 0; i < draws; ++i) sizes.push_back(distribution.quantile(rng.uniform()));
  return sizes;
}

/// The probability that counts in cells of equal probability differ more from their mean than these.
double p_value(const std::vector<double>& parts) {
  std::vector<double> counts(cells);
  for (const double part : parts)
    ++counts[static_cast<std::size_t>(std::clamp(part * cells, 0.0, cells - 1.0))];
  double square = 0;
  const double mean = static_cast<double>(parts.size()) / cells;
  for (const double count : counts) square += (count - mean) * (count - mean) / mean;
  return boost::math::cdf(
      boost::math::complement(boost::math::chi_squared_distribution<>(cells - 1), square));
}

Distribution sieve_curve() {
  Distribution curve;
  curve.kind = DistributionKind::sieve;
  curve.values = {0.05, 0.2, 0.5, 1};
  curve.weights = {0, 0.4, 0.8, 1};
  return curve;
}

/// The distributions of sizes, each between a least and a greatest size.
std::vector<std::pair<std::string, Distribution>> size_distributions() {
  using enum DistributionKind;
  return {{"rosin_rammler", {.kind = rosin_rammler, .a = 0.218, .b = 1.073, .min = 0.05, .max = 1}},
          {"lognormal", {.kind = lognormal, .a = 0.3, .b = 0.5, .min = 0.05, .max = 1.5}},
          {"power_law", {.kind = power_law, .a = 0.1, .b = 2, .c = 0.7}},
          {"sieve", sieve_curve()}};
}

TEST_CASE("sizes by count have the shares of their distribution", "[slow]") {
  for (const auto& [name, distribution] : size_distributions()) {
    INFO(name);
    std::vector<double> parts;
    for (const double size : sample_from(distribution, 7)) parts.push_back(distribution.share_below(size));
    CHECK(p_value(parts) > 1e-4);
  }
}

TEST_CASE("sizes by mass have the shares of the number of pieces, in closed form or by quadrature",
          "[slow]") {
  for (const auto& [name, mass] : size_distributions()) {
    INFO(name);
    // The share of pieces below x is the integral of dM / x^3, here by the midpoint rule over the mass, which
    // does not use the sampler.
    constexpr int steps = 400'000;
    std::vector<double> edges, below{0};
    for (int i = 0; i < steps; ++i) {
      const double size = mass.quantile((i + 0.5) / steps);
      edges.push_back(size);
      below.push_back(below.back() + 1 / (size * size * size));
    }
    const auto share_of_pieces = [&](double size) {
      const auto at = std::lower_bound(edges.begin(), edges.end(), size) - edges.begin();
      return below[static_cast<std::size_t>(at)] / below.back();
    };
    std::vector<double> parts;
    for (const double size : sample_from(pieces_by_mass(mass), 11)) parts.push_back(share_of_pieces(size));
    CHECK(p_value(parts) > 1e-4);
  }
}

TEST_CASE("chi-square tells a wrong sampler: sizes by count are not those by mass", "[slow]") {
  const Distribution mass = size_distributions().front().second;
  const Distribution pieces = pieces_by_mass(mass);
  std::vector<double> parts;
  for (const double size : sample_from(mass, 13)) parts.push_back(pieces.share_below(size));
  CHECK(p_value(parts) < 1e-6);
}

}  // namespace goodness_of_fit_test
