#include "math/polynomial.h"

#include <array>
#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("first_fall finds the first root at which a polynomial falls") {
  // (t - 1)(t - 2)(t - 3)(t - 4): positive at 0, falls at 1 and at 3.
  const std::array<double, 5> quartic{24, -50, 35, -10, 1};
  CHECK(first_fall(quartic, 0, 10).value() == Approx(1).epsilon(1e-14));
  CHECK(first_fall(quartic, 1.5, 10).value() == Approx(3).epsilon(1e-14));
  CHECK(first_fall(quartic, 3.5, 10).value() == 3.5);  // below zero and falling
  CHECK_FALSE(first_fall(quartic, 3.8, 10));           // below zero and rising
  CHECK_FALSE(first_fall(quartic, 0, 0.9));
}

TEST_CASE("a release from zero falls at once, or later when it rises first") {
  CHECK(first_fall(std::array{0.0, 0.0, -4.9}, 0, 10).value() == 0);
  CHECK(first_fall(std::array{0.0, -1.0, 3.0}, 0, 10).value() == 0);
  const double v = 2.5, g = 9.81;
  CHECK(first_fall(std::array{0.0, v, -0.5 * g}, 0, 10).value() == Approx(2 * v / g).epsilon(1e-15));
  CHECK_FALSE(first_fall(std::array{0.0, 0.0, 0.0}, 0, 10));
}

TEST_CASE("a grazing parabola that does not reach zero has no fall") {
  const double depth = GENERATE(1e-12, -1e-12);
  // Lowest value `depth` at t = 1.
  const auto fall = first_fall(std::array{1 + depth, -2.0, 1.0}, 0, 10);
  CHECK(fall.has_value() == (depth < 0));
  if (fall) CHECK(*fall == Approx(1 - 1e-6).epsilon(1e-9));
}
