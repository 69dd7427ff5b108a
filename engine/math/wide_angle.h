#pragma once
// sin, cos and arctan of 128-bit numbers. Relative errors are below 2^-90.

#include <array>

#include "math/wide.h"

namespace flyrock::wide {

inline constexpr Wide half_pi{join(0xc90fdaa22168c234, 0xc4c6628b80dc1cd1), 0};

namespace tables {

/// 2/pi = 0.a2f9..., in hexadecimal digits; enough digits for the largest double.
inline constexpr std::array<u64, 20> two_over_pi = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
    0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
    0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};

/// sin(i/128 pi/2), with 127 fractional bits.
constexpr std::array<u128, 129> make_sines() {
  std::array<u128, 129> table{};
  for (int i = 1; i < 128; ++i) {
    const Wide x = scaled(integer(i) * half_pi, -7);
    Wide sum, term = x;
    for (int n = 1; n < 50; n += 2) {
      sum = sum + term;
      term = -(term * x * x) / integer((n + 1) * (n + 2));
    }
    table[i] = sum.mantissa >> -sum.exponent;
  }
  table[128] = u128{1} << 127;
  return table;
}
inline constexpr std::array<u128, 129> sines = make_sines();

/// arctan(i/128), with 127 fractional bits. Each value follows from the previous one by the arctan of a
/// difference.
constexpr std::array<u128, 129> make_arcs() {
  std::array<u128, 129> table{};
  for (int i = 1; i <= 128; ++i) {
    const Wide x = integer(128) / integer(128 * 128 + i * (i - 1));
    Wide sum, power = x;
    for (int n = 1; n < 24; n += 2) {
      const Wide term = power / integer(n);
      sum = n & 2 ? sum - term : sum + term;
      power = power * x * x;
    }
    table[i] = table[i - 1] + (sum.mantissa >> -sum.exponent);
  }
  return table;
}
inline constexpr std::array<u128, 129> arcs = make_arcs();

}  // namespace tables

/// (quarter + cell / 128) pi/2 + rest, where |rest| is at most half a cell.
struct Angle {
  int quarter = 0;  ///< of 4
  int cell = 0;     ///< 0 to 128
  Wide rest;
};

/// x modulo 2 pi (Payne and Hanek): computes x 2/pi with only those digits of 2/pi that matter modulo 4.
inline Angle reduce(const Wide& x) {
  if (x.exponent < -8) return {0, 0, x};  // below half a cell
  // Digits before `skipped` contribute multiples of 4, so take 256 bits from there on.
  const int skipped = x.exponent > 65 ? x.exponent - 65 : 0;
  const auto digits = [&](int i) {
    const u128 pair = join(tables::two_over_pi[skipped / 64 + i], tables::two_over_pi[skipped / 64 + i + 1]);
    return high(pair << skipped % 64);
  };
  const u64 m = high(x.mantissa);
  const u128 p1 = full_product(m, digits(3)), p2 = full_product(m, digits(2)) + high(p1);
  const u128 p3 = full_product(m, digits(1)) + high(p2), p4 = full_product(m, digits(0)) + high(p3);
  // The product without its last 64 bits; it has `behind` fractional bits.
  u64 word[5] = {low(p2), low(p3), low(p4), high(p4), 0};
  const int behind = 256 - 1 + skipped - x.exponent;
  // Shift to 190 fractional bits and 2 integer bits.
  const int cut = behind - 190;
  const u64* from = word + cut / 64;
  const auto shifted = [&](int i) { return low(join(from[i + 1], from[i]) >> cut % 64); };
  u64 top = shifted(2);
  u128 bottom = join(shifted(1), shifted(0));
  const int quarter = static_cast<int>(top >> 62);
  top &= ~u64{0} >> 2;
  const int cell = static_cast<int>((top + (u64{1} << 54)) >> 55);
  top -= static_cast<u64>(cell) << 55;
  const bool below = top >> 63;
  if (below) {
    bottom = -bottom;
    top = ~top + (bottom == 0);
  }
  const int zeros = top ? std::countl_zero(top) : 64;
  const Wide share =
      zeros == 64 ? normal(bottom, 127 - 190)
                  : Wide{join(top, high(bottom)) << zeros | u128{low(bottom)} << zeros >> 64, 1 - zeros};
  Angle angle{quarter, cell, share * half_pi};
  angle.rest.negative = below;
  if (x.negative) return {(4 - quarter - 1) & 3, 128 - cell, -angle.rest};
  return angle;
}

/// sin of an angle.
inline Wide sine(const Angle& angle) {
  const bool cosine = angle.quarter & 1, negative = angle.quarter & 2;
  const int cell = cosine ? 128 - angle.cell : angle.cell;
  const bool rest_negative = angle.rest.negative != cosine;
  const u128 a = fraction(angle.rest, 7);  // 2^7 |rest|
  const u128 square = product(a, a);       // 2^14 rest^2
  const u64 v = high(square);
  u64 series = short_part(5040) - (product(short_part(362880), v) >> 14);
  series = short_part(120) - (product(series, v) >> 14);
  const u128 loss =
      product(square, part(6) - (product(square, series) >> 14));  // 1 - sin(rest)/rest, times 2^14
  if (cell == 0) {
    constexpr u128 one = u128{1} << 127;
    return Wide{angle.rest.mantissa, angle.rest.exponent, rest_negative != negative} *
           normal(one - (loss >> 15), 0);
  }
  u64 versed = short_part(720) - (product(short_part(40320), v) >> 14);
  versed = short_part(24) - (product(versed, v) >> 14);
  const u128 fall =
      (square >> 1) - (product(square, product(square, versed)) >> 14);  // 1 - cos(rest), times 2^14
  const u128 s = tables::sines[cell], c = tables::sines[128 - cell];
  const u128 across = product(c, a - (product(a, loss) >> 14)) >> 7;
  const u128 along = s - (product(s, fall) >> 14);
  return normal(rest_negative ? along - across : along + across, 0, negative);
}
inline Wide cosine(Angle angle) {
  ++angle.quarter;
  return sine(angle);
}

/// arctan(y / x) for y, x >= 0, not both zero: 0 to pi/2.
inline Wide arc(const Wide& y, const Wide& x) {
  if (smaller(x, y)) return half_pi - arc(x, y);
  int cell = 0;  // y/x is near cell / 128
  if (y.exponent - x.exponent >= -9) {
    const double ratio = narrow({y.mantissa, y.exponent - x.exponent}) / narrow({x.mantissa, 0});
    cell = static_cast<int>(ratio * 128 + 0.5);
  }
  const Wide slope = scaled(integer(cell), -7);
  const Wide t = cell == 0 ? y / x : (y - x * slope) / (x + y * slope);  // |t| < 2^-7
  const u128 a = fraction(t, 7);
  const u128 square = product(a, a);
  const u64 v = high(square);
  u64 series = short_part(9) - (product(short_part(11), v) >> 14);
  series = short_part(7) - (product(series, v) >> 14);
  series = short_part(5) - (product(series, v) >> 14);
  const u128 loss =
      product(square, part(3) - (product(square, series) >> 14));  // 1 - arctan(t)/t, times 2^14
  constexpr u128 one = u128{1} << 127;
  return normal(tables::arcs[cell], 0) + t * normal(one - (loss >> 15), 0);
}

}  // namespace flyrock::wide
