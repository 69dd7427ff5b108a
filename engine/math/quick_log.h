#pragma once
// log, asinh and hypot with 64 bits instead of 128. This is three times as fast, and determines the nearest
// double in most cases. wide_exp_log.h and wide.h compute the others.

#include "math/wide_exp_log.h"

namespace flyrock::wide {

/// The fraction of a normal double as an integer from 2^52 to 2^53, and its exponent:
/// |x| = fraction 2^(exponent - 52).
constexpr u64 fraction_of(double x) { return (std::bit_cast<u64>(x) & 0xfffffffffffff) | u64{1} << 52; }
constexpr int exponent_of(double x) { return static_cast<int>(std::bit_cast<u64>(x) >> 52 & 0x7ff) - 1023; }

/// The size of ln(1 + z) in units of 2^-78, from that of z, |z| < 2^-14.
constexpr u64 quick_log_near_one(u64 size, bool negative) {
  const auto next = [&](u64 c, u64 term) { return negative ? c + (term >> 14) : c - (term >> 14); };
  u64 series = next(short_part(4), product(short_part(5), size));
  series = next(short_part(3), product(series, size));
  series = next(short_part(2), product(series, size));
  return next(size, product(product(size, size), series));
}

/// ln of the number fraction 2^(exponent - 63), fraction >= 2^63, with 116 fractional bits. The steps are
/// those of log2(): the number is multiplied twice by a factor from a table, which leaves 1 + rest. The error
/// is below 2^-74 for a fraction whose last bit is 0, otherwise below 2^-62.
inline i128 quick_log(u64 fraction, int exponent) {
  constexpr u64 root_of_two = 0xb504f333f9de6484;
  const bool large = fraction > root_of_two;
  const u64 m = fraction >> large;  // 0.7 to 1.4, 63 fractional bits
  const tables::Cell& coarse = tables::coarse[static_cast<int>((m + (u64{1} << 55)) >> 56) - 90];
  // The product, less its leading 1: 68 fractional bits.
  const auto r = static_cast<std::int64_t>(full_product(m, static_cast<u64>(coarse.factor)) >> 4);
  const tables::Cell& fine = tables::fine[static_cast<int>((r + (std::int64_t{1} << 53)) >> 54) + 128];
  const std::int64_t shifted = r + fine.factor * (std::int64_t{1} << 46);
  const i128 rest = static_cast<i128>(shifted) * (1 << 22) + static_cast<i128>(r) * fine.factor;  // 90 bits
  const bool negative = rest < 0;
  const u64 tail = quick_log_near_one(low(static_cast<u128>(negative ? -rest : rest) >> 12), negative);
  const i128 sum = (static_cast<i128>(exponent + large) << 116) + coarse.log + fine.log;  // log2
  const auto log = static_cast<i128>(product(static_cast<u128>(sum < 0 ? -sum : sum), ln2.mantissa));
  const auto near_one = static_cast<i128>(static_cast<u128>(tail) << 38);
  return (sum < 0 ? -log : log) + (negative ? -near_one : near_one);
}

/// The double nearest to a result of quick_log, if an error below 2^-bits cannot change it; otherwise 0.
inline double sure_log(i128 log, int bits) {
  const u64 error = u64{1} << (116 - bits);
  const u128 size = static_cast<u128>(log < 0 ? -log : log);
  const int zeros = leading_zeros(size | 1);
  if (zeros > 16) return 0;
  const int cut = 75 - zeros;  // bits that are rounded away
  const u128 rest = size & ((u128{1} << cut) - 1), half = u128{1} << (cut - 1);
  if (rest - half + error <= 2 * error) return 0;
  const u64 kept = static_cast<u64>(size >> cut) + (rest > half);  // a carry increases the exponent
  const u64 sign = static_cast<u64>(log < 0) << 63;
  return std::bit_cast<double>(sign | ((static_cast<u64>(1033 - zeros) << 52) + kept));
}

/// ln(x) of a normal double above 0, if it is sure; otherwise 0.
inline double quick_log(double x) { return sure_log(quick_log(fraction_of(x) << 11, exponent_of(x)), 74); }

/// asinh(x) = ln(x + (1 + x^2)^(1/2)) for 2^-4 <= x < 2^11, if it is sure; otherwise 0.
inline double quick_asinh(double x) {
  const int exponent = exponent_of(x);
  const u64 fraction = fraction_of(x);
  const u128 square = full_product(fraction, fraction) + (u128{1} << (104 - 2 * exponent));  // exact
  const double guess =
      std::sqrt(static_cast<double>(high(square)) * 0x1p64 + static_cast<double>(low(square)));
  const u64 root = static_cast<u64>(guess);
  const auto left = static_cast<std::int64_t>(low(square - full_product(root, root)));
  const double more = static_cast<double>(left) * (0.5 / guess);  // a Newton step
  const u64 sum = fraction + root;
  const int zeros = std::countl_zero(sum), shift = zeros - 1;
  const auto added = static_cast<std::int64_t>(more * static_cast<double>(u64{1} << shift));
  const u64 whole = (sum << shift) + static_cast<u64>(added);
  const int left_zeros = std::countl_zero(whole);
  return sure_log(quick_log(whole << left_zeros, exponent + 11 - shift - left_zeros), 60);
}

/// The root of x^2 + y^2 for 2^-500 < y <= x < 2^500, if it is sure; otherwise 0. With a double r next to it
/// and half the value of its last bit, h, it is r if |x^2 + y^2 - r^2| < 2 r h - h^2, and next to r if not.
inline double quick_hypot(double x, double y) {
  const int exponent = exponent_of(x), shift = exponent - exponent_of(y);
  if (shift > 40) return 0;
  const u64 a = fraction_of(x) << 3, b = fraction_of(y) << 3 >> shift;  // units of 2^(exponent - 55)
  const u128 square = full_product(a, a) + full_product(b, b);          // from 2^110 to 2^113
  const u64 margin = shift > 3 ? 2 * b + 1 : 0;                         // of the bits of b that are lost
  u64 root = static_cast<u64>(std::sqrt(static_cast<double>(static_cast<u64>(square >> 56))) * 0x1p28);
  const u64 half = root >> 56 ? 8 : 4;
  root = (root + half) & ~(2 * half - 1);
  auto rest = static_cast<std::int64_t>(low(square - full_product(root, root)));
  const auto step =
      static_cast<std::int64_t>(2 * root * half);  // from its square to that of a tie, but half^2
  if (rest > step) {
    rest -= 2 * step + static_cast<std::int64_t>(4 * half * half);
    root += 2 * half;
  } else if (rest < -step) {
    rest += 2 * step - static_cast<std::int64_t>(4 * half * half);
    root -= 2 * half;
  }
  const u64 size =
      static_cast<u64>(rest < 0 ? -rest : rest) + margin + (u64{1} << 34);  // narrow() decides ties
  if (size > static_cast<u64>(step) || root - (u64{1} << 56) <= 2 * half) return 0;
  return static_cast<double>(root) * std::bit_cast<double>(static_cast<u64>(1023 + exponent - 55) << 52);
}

}  // namespace flyrock::wide
