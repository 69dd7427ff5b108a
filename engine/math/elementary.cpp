// The elementary functions of <cmath>, under their C names. The programs define and export them, so that
// flyrock, Lua, Boost and plugins call these functions instead of those of the C library, whose last bits
// depend on the processor and on its version. They compute in integers (wide.h) and round once. The result is
// the nearest double, except for 1 argument in 10^9. Special cases follow the C standard. errno and the
// floating-point flags are not changed.

#include <limits>

#include "math/quick_angle.h"
#include "math/quick_log.h"
#include "math/wide_exp_log.h"
#include "math/wide_gamma.h"

using namespace flyrock::wide;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

bool is_finite(double x) { return std::fabs(x) < infinity; }
bool is_special(double x) { return x == 0 || !is_finite(x); }

/// 2^x as a double, for any finite x.
double power_of_two(const Wide& x, bool negative = false) {
  if (x.exponent > 10) return std::copysign(x.negative ? 0 : infinity, negative ? -1. : 1.);
  Wide power = exp2(x);
  power.negative = negative;
  return narrow(power);
}

double logarithm(double x, const Wide& unit) {
  if (std::isnan(x)) return x;
  if (x == 0) return -infinity;
  if (x < 0) return no_number;
  return is_finite(x) ? narrow(log2(widen(x)) * unit) : x;
}

/// Whether y is an integer, and whether it is odd. Doubles of 2^53 and more are even.
bool whole(double y) { return std::floor(y) == y; }
bool odd(double y) { return std::fabs(y) < 0x1p53 && static_cast<long long>(y) & 1; }

double power_of_special(double x, double y) {
  if (x == 1 || y == 0) return 1;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (!is_finite(y)) {
    if (std::fabs(x) == 1) return 1;
    return (std::fabs(x) > 1) == (y > 0) ? infinity : 0;
  }
  const double size = (x == 0) == (y > 0) ? 0 : infinity;  // power of a zero or an infinity
  return std::signbit(x) && whole(y) && odd(y) ? -size : size;
}

Wide with_sign_of(Wide a, double x) {
  a.negative = std::signbit(x);
  return a;
}

bool is_quick(double x) { return std::fabs(x) >= 0x1p-8 && std::fabs(x) < 0x1p20; }
double full_sine(double x) {
  if (is_special(x)) return x == 0 ? x : no_number;
  return narrow(sine(reduce(widen(x))));
}
double full_cosine(double x) {
  if (is_special(x)) return x == 0 ? 1 : no_number;
  return narrow(cosine(reduce(widen(x))));
}

/// The root of 1 - x^2.
Wide leg(const Wide& x) { return root((integer(1) - x) * (integer(1) + x)); }

}  // namespace

extern "C" {

double exp2(double x) {
  if (!is_finite(x)) return x == -infinity ? 0 : x;
  return power_of_two(widen(x));
}

double exp(double x) {
  if (!is_finite(x)) return x == -infinity ? 0 : x;
  return power_of_two(widen(x) * log2_e);
}

double expm1(double x) {
  if (is_special(x)) return x == -infinity ? -1 : x;
  return x > 1000 ? infinity : x < -1000 ? -1 : narrow(expm1(widen(x)));
}

double log2(double x) { return logarithm(x, integer(1)); }
double log(double x) {
  if (x >= 0x1p-1000 && x < infinity)
    if (const double sure = quick_log(x); sure != 0) return sure;
  return logarithm(x, ln2);
}
double log10(double x) { return logarithm(x, log10_2); }

double log1p(double x) {
  if (x == -1) return -infinity;
  if (x < -1) return no_number;
  return is_special(x) ? x : narrow(log1p(widen(x)));
}

double pow(double x, double y) {
  if (is_special(x) || !is_finite(y) || x == 1 || y == 0) return power_of_special(x, y);
  if (x < 0 && !whole(y)) return no_number;
  return power_of_two(log2(magnitude(widen(x))) * widen(y), x < 0 && odd(y));
}

double cbrt(double x) {
  if (is_special(x)) return x;
  return narrow(with_sign_of(exp2(log2(magnitude(widen(x))) * one_over(3)), x));
}

double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return infinity;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double a_size = std::fabs(x), b_size = std::fabs(y);
  const double longer = a_size < b_size ? b_size : a_size, shorter = a_size < b_size ? a_size : b_size;
  if (shorter > 0x1p-500 && longer < 0x1p500)
    if (const double length = quick_hypot(longer, shorter); length != 0) return length;
  const Wide a = widen(x), b = widen(y);
  return narrow_root(a * a + b * b);
}

double sin(double x) {
  const QuickAngle angle = is_quick(x) ? quick_angle(x) : QuickAngle{};
  const double sine = sure(angle.sine, angle.sine_negative);
  return sine != 0 ? sine : full_sine(x);
}

double cos(double x) {
  const QuickAngle angle = is_quick(x) ? quick_angle(x) : QuickAngle{};
  const double cosine = sure(angle.cosine, angle.cosine_negative);
  return cosine != 0 ? cosine : full_cosine(x);
}

void sincos(double x, double* s, double* c) {
  const QuickAngle angle = is_quick(x) ? quick_angle(x) : QuickAngle{};
  *s = sure(angle.sine, angle.sine_negative);
  *c = sure(angle.cosine, angle.cosine_negative);
  if (*s == 0) *s = full_sine(x);
  if (*c == 0) *c = full_cosine(x);
}

double tan(double x) {
  if (is_special(x)) return x == 0 ? x : no_number;
  if (is_quick(x))
    if (const double tangent = sure_tangent(quick_angle(x)); tangent != 0) return tangent;
  const Angle angle = reduce(widen(x));
  return narrow(sine(angle) / cosine(angle));
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  Wide angle;
  if (!is_finite(x) || !is_finite(y)) {
    angle = arc(integer(!is_finite(y)), integer(!is_finite(x)));
  } else if (y != 0 || x != 0) {
    angle = arc(magnitude(widen(y)), magnitude(widen(x)));
  }
  return narrow(with_sign_of(std::signbit(x) ? scaled(half_pi, 1) - angle : angle, y));
}

double atan(double x) { return is_special(x) && x == 0 ? x : atan2(x, 1); }

double asin(double x) {
  if (x == 0 || std::isnan(x)) return x;
  if (std::fabs(x) > 1) return no_number;
  const Wide a = widen(x);
  return narrow(with_sign_of(arc(magnitude(a), leg(a)), x));
}

double acos(double x) {
  if (std::isnan(x)) return x;
  if (std::fabs(x) > 1) return no_number;
  const Wide a = widen(x), angle = arc(leg(a), magnitude(a));
  return narrow(x < 0 ? scaled(half_pi, 1) - angle : angle);
}

double sinh(double x) {
  if (is_special(x)) return x;
  if (std::fabs(x) > 1000) return std::copysign(infinity, x);
  const Wide growth = expm1(magnitude(widen(x)));
  return narrow(with_sign_of(scaled(growth + growth / (growth + integer(1)), -1), x));
}

double cosh(double x) {
  if (std::isnan(x)) return x;
  if (std::fabs(x) > 1000) return infinity;
  const Wide power = exp2(magnitude(widen(x)) * log2_e);
  return narrow(scaled(power + inverse(power), -1));
}

double tanh(double x) {
  if (x == 0 || std::isnan(x)) return x;
  if (std::fabs(x) > 100) return std::copysign(1, x);
  const Wide growth = expm1(scaled(magnitude(widen(x)), 1));
  return narrow(with_sign_of(growth / (growth + integer(2)), x));
}

double asinh(double x) {
  if (is_special(x)) return x;
  if (std::fabs(x) >= 0x1p-4 && std::fabs(x) < 0x1p11)
    if (const double size = quick_asinh(std::fabs(x)); size != 0) return std::copysign(size, x);
  const Wide a = magnitude(widen(x)), square = a * a, across = root(integer(1) + square);
  // Of small a the sum a + across would lose bits.
  const Wide size = a.exponent >= -4 ? log2(a + across) * ln2 : log1p(a + square / (integer(1) + across));
  return narrow(with_sign_of(size, x));
}

double acosh(double x) {
  if (std::isnan(x) || x == infinity) return x;
  if (x < 1) return no_number;
  const Wide above = widen(x) - integer(1);
  return narrow(log1p(above + root(above * (above + integer(2)))));
}

double atanh(double x) {
  if (x == 0 || std::isnan(x)) return x;
  if (std::fabs(x) >= 1) return std::fabs(x) > 1 ? no_number : std::copysign(infinity, x);
  const Wide a = magnitude(widen(x));
  return narrow(with_sign_of(scaled(log1p(scaled(a / (integer(1) - a), 1)), -1), x));
}

double erf(double x) {
  if (x == 0 || std::isnan(x)) return x;
  return std::copysign(std::fabs(x) > 6 ? 1 : narrow(erf(magnitude(widen(x)))), x);
}

double erfc(double x) {
  if (std::isnan(x)) return x;
  if (x > 28) return 0;
  if (x < -6) return 2;
  if (x > 1.5) return narrow(erfc(widen(x)));
  return x == 0 ? 1 : narrow(integer(1) - with_sign_of(erf(magnitude(widen(x))), x));
}

double tgamma(double x) {
  if (x == 0) return std::copysign(infinity, x);
  if (!is_finite(x)) return x < 0 ? no_number : x;
  if (x < 0 && whole(x)) return no_number;
  if (x > 172) return infinity;
  if (x > 0) return narrow(gamma(widen(x)));
  if (x < -190) return odd(std::floor(x)) ? -0.0 : 0.0;
  return narrow(scaled(half_pi, 1) / (sine_of_pi_times(x) * gamma(integer(1) - widen(x))));
}

double lgamma(double x) {
  if (!is_finite(x)) return x * x;
  if (x <= 0 && whole(x)) return infinity;
  if (x > 0) return narrow(log_gamma(widen(x)));
  return narrow(log2(scaled(half_pi, 1) / magnitude(sine_of_pi_times(x))) * ln2 -
                log_gamma(integer(1) - widen(x)));
}

}  // extern "C"
