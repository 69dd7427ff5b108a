#include "random/pieces_by_mass.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>

using namespace flyrock;

namespace pieces_by_mass_test {

using enum DistributionKind;

TEST_CASE("pieces of a lognormal mass are lognormal, their median exp(-3 s^2) of it") {
  // x^-3 times the density of ln N(m, s) is that of ln N(m - 3 s^2, s).
  const double s = 0.5, median = 0.3, low = 0.05, high = 1.5;
  const Distribution pieces =
      pieces_by_mass({.kind = lognormal, .a = median, .b = s, .min = low, .max = high});
  const Distribution closed{
      .kind = lognormal, .a = median * std::exp(-3 * s * s), .b = s, .min = low, .max = high};
  for (const double u : {0.001, 0.1, 0.5, 0.9, 0.999, 0.999999})
    CHECK(pieces.quantile(u) == Approx(closed.quantile(u)).epsilon(2e-5));
}

TEST_CASE("pieces of the mass of a power law are a power law with three more in its exponent") {
  const Distribution pieces = pieces_by_mass({.kind = power_law, .a = 0.1, .b = 2, .c = 0.7});
  const Distribution closed{.kind = power_law, .a = 0.1, .b = 2, .c = 3.7};
  for (const double u : {0.001, 0.1, 0.5, 0.9, 0.999, 0.999999})
    CHECK(pieces.quantile(u) == Approx(closed.quantile(u)).epsilon(2e-5));
}

TEST_CASE("pieces of a Rosin-Rammler mass give the mass back") {
  const Distribution mass{.kind = rosin_rammler, .a = 0.218, .b = 1.073, .min = 0.05, .max = 1};
  REQUIRE(by_mass_fault(mass).empty());
  const Distribution pieces = pieces_by_mass(mass);
  // The mass below x is the integral of x^3 over the quantiles of the pieces.
  const auto cube = [&](double u) { return std::pow(pieces.quantile(u), 3); };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double all = Rule::integrate(cube, 0.0, 1.0, 12, 1e-9);
  for (const double x : {0.06, 0.1, 0.3, 0.8})
    CHECK(Rule::integrate(cube, 0.0, pieces.cumulative(x), 12, 1e-9) / all ==
          Approx(mass.share_below(x)).epsilon(1e-4));
}

TEST_CASE("pieces of a sieve are exact at its sizes, and so is what is cut off") {
  Distribution mass;
  mass.kind = sieve;
  mass.values = {0.1, 0.2, 0.4};
  mass.weights = {0, 0.5, 1};
  const Distribution pieces = pieces_by_mass(mass);
  // Equal masses over equal ratios of sizes: eight times as many pieces in the finer half.
  CHECK(pieces.cumulative(0.2) == Approx(8.0 / 9));
  mass.min = 0.2;
  CHECK(pieces_by_mass(mass).lowest() == 0.2);
  CHECK(pieces_by_mass(mass).quantile(0.5) > 0.2);
}

TEST_CASE("a mass without a least size has no number of pieces") {
  Distribution mass{.kind = rosin_rammler, .a = 0.2, .b = 1};
  CHECK(by_mass_fault(mass) == "pieces without a least size have no number: give it a `min`");
  mass.kind = integer;
  CHECK_FALSE(by_mass_fault(mass).empty());
}

}  // namespace pieces_by_mass_test
