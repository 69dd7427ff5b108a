// Random heights: their variance and correlation against the spectrum, and that they depend on the key alone.

#include "random/gaussian_field.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

namespace {

std::vector<double> field(int rows, int columns, const RoughSpectrum& spectrum, std::uint64_t trial) {
  DrawKey key;
  key.trial = trial;
  RandomStream rng(7, "terrain", key);
  return gaussian_field(rows, columns, spectrum, rng);
}

}  // namespace

TEST_CASE("rough heights have mean 0 and standard deviation 1, on a line and on a surface") {
  for (const int rows : {1, 40}) {
    double sum = 0, squares = 0;
    int count = 0;
    for (std::uint64_t trial = 0; trial < 400; ++trial)
      for (const double z : field(rows, 50, {2, 0.8, 0.5}, trial)) {
        sum += z;
        squares += z * z;
        ++count;
      }
    CHECK(std::abs(sum / count) < 0.06);
    CHECK(squares / count == Approx(1).margin(0.05));
  }
}

TEST_CASE("rough heights are correlated as their spectrum says") {
  // hurst 0.5 on a line: the spectrum 1/(1 + (k l)^2) belongs to the correlation exp(-distance / l).
  const RoughSpectrum spectrum{4, 0.5, 0.25};
  std::vector<double> products(40, 0.0);
  const int trials = 3000;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto z = field(1, 40, spectrum, trial);
    for (std::size_t lag = 0; lag < products.size(); ++lag) products[lag] += z[0] * z[lag] / trials;
  }
  for (const int lag : {4, 8, 16, 32}) CHECK(products[lag] == Approx(std::exp(-lag * 0.25 / 4)).margin(0.07));
}

TEST_CASE("a surface of rough heights is the same in both directions") {
  const RoughSpectrum spectrum{2, 0.8, 0.5};
  double along = 0, across = 0;
  const int trials = 2000;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto z = field(12, 20, spectrum, trial);
    along += z[0] * z[3] / trials;
    across += z[0] * z[3 * 20] / trials;
  }
  CHECK(along == Approx(across).margin(0.08));
  CHECK((along > 0.3 && along < 0.8));
}

TEST_CASE("the same key gives the same heights, another trial gives others") {
  CHECK(field(5, 6, {2, 0.8, 0.5}, 3) == field(5, 6, {2, 0.8, 0.5}, 3));
  CHECK(field(5, 6, {2, 0.8, 0.5}, 3) != field(5, 6, {2, 0.8, 0.5}, 4));
}
