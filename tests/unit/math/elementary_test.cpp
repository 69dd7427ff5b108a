// The elementary functions that the programs define (engine/math/elementary.cpp).
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#ifdef FLYROCK_HAS_QUADMATH
#include <quadmath.h>
#endif

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

#ifdef FLYROCK_HAS_QUADMATH

/// A function, the same with 113 bits, and where it is compared: evenly over [low, high], or over their
/// powers of 2 with either sign.
struct Pair {
  const char* name;
  double (*ours)(double);
  __float128 (*precise)(__float128);
  double low, high;
  enum { even, powers, positive_powers } spread = even;
};

// Long arguments of sin and cos are few: libquadmath takes 30 times as long for them.
const Pair pairs[] = {
    {"sin", sin, sinq, -10, 10},
    {"sin", sin, sinq, -40, 60, Pair::powers},
    {"cos", cos, cosq, -10, 10},
    {"cos", cos, cosq, -40, 60, Pair::powers},
    {"tan", tan, tanq, -10, 10},
    {"tan", tan, tanq, -40, 60, Pair::powers},
    {"asin", asin, asinq, -1, 1},
    {"asin", asin, asinq, -40, 0, Pair::powers},
    {"acos", acos, acosq, -1, 1},
    {"acos", acos, acosq, -40, 0, Pair::powers},
    {"atan", atan, atanq, -4, 4},
    {"atan", atan, atanq, -60, 60, Pair::powers},
    {"sinh", sinh, sinhq, -4, 4},
    {"sinh", sinh, sinhq, -60, 9, Pair::powers},
    {"cosh", cosh, coshq, -4, 4},
    {"cosh", cosh, coshq, -60, 9, Pair::powers},
    {"tanh", tanh, tanhq, -4, 4},
    {"tanh", tanh, tanhq, -60, 6, Pair::powers},
    {"asinh", asinh, asinhq, -4, 4},
    {"asinh", asinh, asinhq, -60, 1000, Pair::powers},
    {"acosh", acosh, acoshq, 1, 4},
    {"acosh", acosh, acoshq, 0, 1000, Pair::positive_powers},
    {"atanh", atanh, atanhq, -1, 1},
    {"atanh", atanh, atanhq, -60, 0, Pair::powers},
    {"exp", exp, expq, -740, 709},
    {"exp", exp, expq, -60, 9, Pair::powers},
    {"exp2", exp2, exp2q, -1070, 1023},
    {"exp2", exp2, exp2q, -60, 9, Pair::powers},
    {"expm1", expm1, expm1q, -4, 4},
    {"expm1", expm1, expm1q, -60, 9, Pair::powers},
    {"log", log, logq, 0.5, 2},
    {"log", log, logq, -1070, 1023, Pair::positive_powers},
    {"log2", log2, log2q, 0.5, 2},
    {"log2", log2, log2q, -1070, 1023, Pair::positive_powers},
    {"log10", log10, log10q, 0.5, 2},
    {"log10", log10, log10q, -1070, 1023, Pair::positive_powers},
    {"log1p", log1p, log1pq, -1, 4},
    {"log1p", log1p, log1pq, -60, 1000, Pair::positive_powers},
    {"cbrt", cbrt, cbrtq, -10, 10},
    {"cbrt", cbrt, cbrtq, -1070, 1023, Pair::powers},
    {"erf", erf, erfq, -6, 6},
    {"erf", erf, erfq, -60, 2, Pair::powers},
    {"erfc", erfc, erfcq, -6, 26},
    {"erfc", erfc, erfcq, -60, 4, Pair::powers},
    {"tgamma", tgamma, tgammaq, 0, 170},
    {"lgamma", lgamma, lgammaq, 0, 10},
    {"lgamma", lgamma, lgammaq, -60, 1000, Pair::positive_powers},
};

double argument(const Pair& pair, std::mt19937_64& random) {
  const double share = std::ldexp(static_cast<double>(random() >> 11), -53);
  const double x = pair.low + (pair.high - pair.low) * share;
  if (pair.spread == Pair::even) return x;
  const bool negative = pair.spread == Pair::powers && random() & 1;
  const double size = std::ldexp(1 + std::ldexp(static_cast<double>(random() >> 11), -53),
                                 static_cast<int>(std::floor(x)) - 1);
  return negative ? -size : size;
}

void compare(int count) {
  std::mt19937_64 random(1);
  for (const Pair& pair : pairs) {
    for (int i = 0; i < count; ++i) {
      const double x = argument(pair, random);
      const double nearest = static_cast<double>(pair.precise(x));
      if (!same(pair.ours(x), nearest)) {
        INFO(pair.name << "(" << std::hexfloat << x << "): the nearest double is " << nearest);
        CHECK(pair.ours(x) == nearest);
      }
    }
  }
  for (int i = 0; i < count; ++i) {
    const double x = argument({"", exp, expq, -300, 300, Pair::powers}, random);
    const double y = argument({"", exp, expq, -8, 8, Pair::powers}, random);
    INFO(std::hexfloat << x << ", " << y);
    const auto check = [&](double ours, __float128 precise) {
      if (!same(ours, static_cast<double>(precise))) CHECK(ours == static_cast<double>(precise));
    };
    check(pow(std::fabs(x), y / 64), powq(std::fabs(x), y / 64));
    check(atan2(x, y), atan2q(x, y));
    check(atan2(x, x * y), atan2q(x, x * y));
    check(hypot(x, x * y), hypotq(x, x * y));
  }
}

#endif

}  // namespace

TEST_CASE("the elementary functions give the nearest double") {
#ifdef FLYROCK_HAS_QUADMATH
  compare(2000);
#else
  WARN("SKIPPED: no libquadmath to compare with");
#endif
}

TEST_CASE("the elementary functions give the nearest double of many arguments", "[slow]") {
#ifdef FLYROCK_HAS_QUADMATH
  compare(50'000);
#else
  WARN("SKIPPED: no libquadmath to compare with");
#endif
}

TEST_CASE("the double nearest to a multiple of pi/2 is reduced to full precision") {
  // 6381956970095103 2^797; Muller and others, Handbook of floating-point arithmetic, 11.
  CHECK(cos(0x1.6ac5b262ca1ffp+849) == -0x1.14ae72e6ba22fp-61);
  CHECK(sin(0x1.6ac5b262ca1ffp+849) == 1);
}

TEST_CASE("special arguments of the elementary functions give what the C standard says") {
  for (const auto f : {sin, tan, asin, atan, sinh, tanh, asinh, atanh, expm1, log1p, erf}) {
    CHECK(same(f(0.0), 0.0));
    CHECK(same(f(-0.0), -0.0));
    CHECK(f(5e-324) == 5e-324);
  }
  for (const auto f : {sin, cos,  tan,   asin, acos, atan,  sinh,  cosh, tanh, asinh, acosh,  atanh,
                       exp, exp2, expm1, log,  log2, log10, log1p, cbrt, erf,  erfc,  tgamma, lgamma})
    CHECK(std::isnan(f(std::nan(""))));
  for (const auto f : {sin, cos, tan, asin, acos, atanh}) CHECK(std::isnan(f(infinity)));
  for (const auto f : {cosh, acosh, exp, exp2, expm1, log, log2, log10, log1p, cbrt, tgamma, lgamma})
    CHECK(f(infinity) == infinity);
  for (const auto f : {log, log2, log10}) {
    CHECK(f(0) == -infinity);
    CHECK(same(f(1), 0.0));
    CHECK(std::isnan(f(-1)));
  }
  CHECK(exp(710) == infinity);
  CHECK(same(exp(-746), 0.0));
  CHECK(exp(-745) == 0x1p-1074);
  CHECK(expm1(-infinity) == -1);
  CHECK(log1p(-1) == -infinity);
  CHECK(exp2(-1074) == 0x1p-1074);
  CHECK(log10(1e22) == 22);
  CHECK(cbrt(-27) == -3);
  CHECK(tanh(infinity) == 1);
  CHECK(erfc(-infinity) == 2);
  CHECK(same(erfc(30), 0.0));
  CHECK(tgamma(23) == 1124000727777607680000.0);
  CHECK(tgamma(-0.0) == -infinity);
  CHECK(std::isnan(tgamma(-3)));
  CHECK(same(lgamma(2), 0.0));
}

TEST_CASE("special arguments of pow, atan2 and hypot give what the C standard says") {
  const double none = std::nan("");
  CHECK(pow(none, 0) == 1);
  CHECK(pow(1, none) == 1);
  CHECK(std::isnan(pow(-2, 0.5)));
  CHECK(same(pow(-0.0, 3), -0.0));
  CHECK(pow(-0.0, -3) == -infinity);
  CHECK(pow(-0.0, -2) == infinity);
  CHECK(pow(-1, infinity) == 1);
  CHECK(same(pow(0.5, infinity), 0.0));
  CHECK(pow(-infinity, 3) == -infinity);
  CHECK(pow(-3, 3) == -27);
  CHECK(pow(-3, 0x1p60) == infinity);
  CHECK(pow(2, -1074) == 0x1p-1074);
  CHECK(same(atan2(0.0, 1), 0.0));
  CHECK(same(atan2(-0.0, 1), -0.0));
  CHECK(atan2(0.0, -0.0) == 0x1.921fb54442d18p+1);
  CHECK(atan2(-0.0, -1) == -0x1.921fb54442d18p+1);
  CHECK(atan2(infinity, -infinity) == 0x1.2d97c7f3321d2p+1);
  CHECK(atan2(1, -infinity) == 0x1.921fb54442d18p+1);
  CHECK(hypot(-infinity, none) == infinity);
  CHECK(hypot(3e300, -4e300) == 5e300);
  CHECK(same(hypot(0, -0.0), 0.0));
}

TEST_CASE("functions that can be computed in two ways agree to the bit") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10'000; ++i) {
    const double x = std::ldexp(static_cast<double>(random() >> 11), -48) - 16;
    double s, c;
    ::sincos(x, &s, &c);
    CHECK((s == sin(x) && c == cos(x)));
    CHECK(pow(x, 2) == x * x);
    CHECK(pow(std::fabs(x), 0.5) == std::sqrt(std::fabs(x)));
    const double few_bits = std::ldexp(static_cast<double>(random() >> 37), -20);  // its square is a tie
    CHECK(pow(few_bits, 2) == few_bits * few_bits);
  }
}
