#pragma once
// Numbers with 128 bits, stored in integers. The elementary functions (elementary.cpp) compute with them.
//
//   value = (-1)^negative * mantissa * 2^(exponent - 127),   2^127 <= mantissa < 2^128, or 0 with a very
//   small exponent,
//
// so 2^exponent <= |value| < 2^(exponent + 1). Operations truncate; their relative error is below 2^-125.
// Integers give the same bits on every processor, with every compiler and every flag.

#include <bit>
#include <cmath>
#include <cstdint>

namespace flyrock::wide {

using u64 = std::uint64_t;
__extension__ using u128 = unsigned __int128;
__extension__ using i128 = __int128;

constexpr u128 join(u64 high, u64 low) { return static_cast<u128>(high) << 64 | low; }
constexpr u64 high(u128 a) { return static_cast<u64>(a >> 64); }
constexpr u64 low(u128 a) { return static_cast<u64>(a); }
constexpr u128 full_product(u64 a, u64 b) { return static_cast<u128>(a) * b; }

/// a b / 2^64, cut.
constexpr u64 product(u64 a, u64 b) { return high(full_product(a, b)); }
/// a b / 2^128, at most 3 too small.
constexpr u128 product(u128 a, u128 b) {
  return full_product(high(a), high(b)) + product(high(a), low(b)) + product(low(a), high(b));
}
/// a b / 2^64, cut.
constexpr u128 product(u128 a, u64 b) { return full_product(high(a), b) + product(low(a), b); }

constexpr int leading_zeros(u128 a) {
  return high(a) ? std::countl_zero(high(a)) : 64 + std::countl_zero(low(a));
}

struct Wide {
  u128 mantissa = 0;
  int exponent = -1'000'000;  ///< of zero: below all others
  bool negative = false;
};

/// mantissa 2^(exponent - 127) of any mantissa.
constexpr Wide normal(u128 mantissa, int exponent, bool negative = false) {
  if (mantissa == 0) return {};
  const int zeros = leading_zeros(mantissa);
  return {mantissa << zeros, exponent - zeros, negative};
}

constexpr Wide integer(long long n) {
  return normal(n < 0 ? -static_cast<u128>(n) : static_cast<u128>(n), 127, n < 0);
}

/// A finite double, without error.
constexpr Wide widen(double x) {
  const u64 bits = std::bit_cast<u64>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const u64 fraction = bits & 0xfffffffffffff;
  const bool negative = bits >> 63;
  if (exponent == 0) return normal(fraction, 127 - 1074, negative);
  return {join((fraction | u64{1} << 52) << 11, 0), exponent - 1023, negative};
}

/// The nearest double, ties to even. A value within 2^-87 of a tie counts as a tie, because a computed value
/// of an exact result has a small error: pow(x, 2) must equal x * x.
constexpr double narrow(const Wide& a) {
  const u64 sign = static_cast<u64>(a.negative) << 63;
  if (a.exponent > 1023) return std::bit_cast<double>(sign | u64{0x7ff} << 52);
  const int cut = a.exponent < -1022 ? 75 - 1022 - a.exponent : 75;  // subnormal numbers have fewer bits
  if (cut > 128) return std::bit_cast<double>(sign);
  u64 kept = cut == 128 ? 0 : static_cast<u64>(a.mantissa >> cut);
  const u128 rest = a.mantissa << (128 - cut);  // as a share of the last bit kept
  const u128 half = u128{1} << 127;
  const u128 window = u128{1} << (40 + 128 - cut);
  const bool tie = rest - half + window <= 2 * window;
  if (tie ? kept & 1 : rest > half) ++kept;  // a carry increases the exponent
  if (cut > 75) return std::bit_cast<double>(sign | kept);
  return std::bit_cast<double>(sign | ((static_cast<u64>(a.exponent + 1022) << 52) + kept));
}

constexpr Wide operator-(Wide a) {
  a.negative = !a.negative;
  return a;
}
constexpr Wide magnitude(Wide a) {
  a.negative = false;
  return a;
}
/// a 2^n.
constexpr Wide scaled(Wide a, int n) {
  a.exponent += n;
  return a;
}

constexpr Wide operator*(const Wide& a, const Wide& b) {
  const u128 mantissa = product(a.mantissa, b.mantissa);  // 2^126 or more, or zero
  const bool small = !(mantissa >> 127);
  return {mantissa << small, a.exponent + b.exponent + 1 - small, a.negative != b.negative};
}

constexpr bool smaller(const Wide& a, const Wide& b) {  // |a| < |b|
  return a.exponent != b.exponent ? a.exponent < b.exponent : a.mantissa < b.mantissa;
}

constexpr Wide operator+(Wide a, Wide b) {
  if (smaller(a, b)) {
    const Wide larger = b;
    b = a;
    a = larger;
  }
  const int shift = a.exponent - b.exponent;
  if (shift > 127) return a;
  const u128 added = b.mantissa >> shift;
  if (a.negative != b.negative) return normal(a.mantissa - added, a.exponent, a.negative);
  const u128 sum = a.mantissa + added;
  if (sum >= a.mantissa) return {sum, a.exponent, a.negative};
  return {sum >> 1 | u128{1} << 127, a.exponent + 1, a.negative};
}
constexpr Wide operator-(const Wide& a, const Wide& b) { return a + -b; }

/// 1/a: a quotient of 64 bits, followed by a Newton step.
constexpr Wide inverse(const Wide& a) {
  const Wide one = integer(1), unit{a.mantissa, 0};
  const u64 leading = high(a.mantissa);  // 2^63 or more
  const u64 quotient = leading == u64{1} << 63 ? ~u64{0} : static_cast<u64>((u128{1} << 127) / leading);
  const Wide guess = normal(join(quotient, 0), -1);
  const Wide x = guess + guess * (one - unit * guess);
  return {x.mantissa, x.exponent - a.exponent, a.negative};
}
constexpr Wide operator/(const Wide& a, const Wide& b) { return a * inverse(b); }

/// The square root of a non-negative number: a Newton step from the root as a double. Error below 2^-104.
inline Wide root(const Wide& a) {
  if (a.mantissa == 0) return a;
  const int half = a.exponent >> 1;
  const Wide unit = scaled(a, -2 * half);  // 1 to 4
  const double guess = std::sqrt(narrow(unit));
  const Wide wide_guess = widen(guess);
  return scaled(wide_guess + (unit - wide_guess * wide_guess) * widen(0.5 / guess), half);
}

/// The double nearest to that root. In most cases it is the root as a double: then a lies between the squares
/// of the middles to its neighbours, which are exact in integers.
inline double narrow_root(const Wide& a) {
  constexpr u128 margin = 1024;  // the squares are within 2^-96 of a tie: root() decides
  const int half = a.exponent >> 1;
  if (a.mantissa == 0 || half < -1000 || half > 1000) return narrow(root(a));
  const Wide unit = scaled(a, -2 * half);                     // 1 to 4
  const u128 square = unit.mantissa >> (21 - unit.exponent);  // 106 fractional bits
  const double guess = std::sqrt(narrow(unit));
  const u64 twice = static_cast<u64>(guess * 0x1p53);
  const u128 low = full_product(twice - 1, twice - 1), high = full_product(twice + 1, twice + 1);
  if (square < low + margin || square + margin > high) return narrow(root(a));
  return guess * std::bit_cast<double>(static_cast<u64>(1023 + half) << 52);
}

/// The fractional bits of a / 2^-shift, for 0 <= a < 2^-shift, as a fixed-point number.
constexpr u128 fraction(const Wide& a, int shift) {
  const int cut = -1 - shift - a.exponent;
  return cut > 127 ? 0 : a.mantissa >> cut;
}

/// 1/n, n > 1.
constexpr Wide one_over(u64 n) { return normal(~u128{0} / n, -1); }

/// 1/n as a fraction of 128 and of 64 bits, n > 1: coefficients of series.
constexpr u128 part(u64 n) { return ~u128{0} / n; }
constexpr u64 short_part(u64 n) { return high(part(n)); }

}  // namespace flyrock::wide
