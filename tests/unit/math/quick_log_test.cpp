// The fast paths of log, asinh and hypot (engine/math/quick_log.h): where they are sure, they agree with the
// functions of 128 bits.
#include "math/quick_log.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace flyrock::wide;

namespace {

/// A number from 2^low to 2^high, whose exponents are equally frequent.
double number(std::mt19937_64& random, int low, int high) {
  const double fraction = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
  return std::ldexp(fraction, low + static_cast<int>(random() % static_cast<unsigned>(high - low)));
}

double full_log(double x) { return narrow(log2(widen(x)) * ln2); }
double full_asinh(double x) { return narrow(log2(widen(x) + root(integer(1) + widen(x) * widen(x))) * ln2); }
double full_hypot(double x, double y) { return narrow(root(widen(x) * widen(x) + widen(y) * widen(y))); }

constexpr int draws = 200'000;

}  // namespace

TEST_CASE("a quick logarithm is the nearest one, and few are not sure") {
  std::mt19937_64 random(1);
  int unsure = 0, different = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = i % 2 ? number(random, -1, 1) : number(random, -900, 900);
    const double quick = quick_log(x);
    unsure += quick == 0;
    different += quick != 0 && quick != full_log(x);
  }
  CHECK(different == 0);
  CHECK(unsure < draws / 20);
}

TEST_CASE("a quick asinh is the nearest one, and few are not sure") {
  std::mt19937_64 random(2);
  int unsure = 0, different = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = number(random, -4, 11);
    const double quick = quick_asinh(x);
    unsure += quick == 0;
    different += quick != 0 && quick != full_asinh(x);
  }
  CHECK(different == 0);
  CHECK(unsure < draws / 20);
}

TEST_CASE("a quick hypot is the nearest one, also where it is exact or close to a tie") {
  std::mt19937_64 random(3);
  int unsure = 0, different = 0;
  for (int i = 0; i < draws; ++i) {
    double x = number(random, -5, 5), y = number(random, -5, 5);
    if (i % 4 == 0) x = std::floor(16 * x), y = std::floor(16 * y) + 1;                // many whole roots
    if (i % 4 == 1) x = std::floor(x) + 64, y = std::ldexp(number(random, 0, 1), -8);  // and many near x
    if (x < y) std::swap(x, y);
    const double quick = quick_hypot(x, y);
    unsure += quick == 0;
    different += quick != 0 && quick != full_hypot(x, y);
  }
  CHECK(different == 0);
  CHECK(unsure < draws / 2);
}
