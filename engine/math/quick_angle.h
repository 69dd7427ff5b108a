#pragma once
// sin, cos and tan with 64 bits instead of 128. This is twice as fast, and determines the nearest double in
// 19 of 20 cases. wide_angle.h computes the others.

#include "math/wide_angle.h"

namespace flyrock::wide {

/// Magnitudes and signs of sin and cos, with 63 fractional bits. The error is less than 4 units of the last
/// bit.
struct QuickAngle {
  u64 sine = 0, cosine = 0;
  bool sine_negative = false, cosine_negative = false;
};

/// For 2^-8 <= |x| < 2^20; see reduce() and sine() for the steps.
[[gnu::always_inline]] inline QuickAngle quick_angle(double x) {
  const u64 bits = std::bit_cast<u64>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
  const u64 m = bits << 11 | u64{1} << 63;
  // The angle in quarter turns, with 126 fractional bits: the quarter, the cell in it, and the position in
  // the cell.
  const u128 turned = full_product(m, tables::two_over_pi[0]) + product(m, tables::two_over_pi[1]);
  const u128 quarters = turned >> 9 << ((exponent + 8) & 31);
  const u64 left = low(quarters >> 55);
  const bool below = left >> 63;  // the next cell is nearer
  const unsigned quarter = static_cast<unsigned>(quarters >> 126);
  const unsigned cell = static_cast<unsigned>(high(quarters) >> 55 & 127) + below;
  const u64 a = product(below ? -left : left, high(half_pi.mantissa)) << 1;  // 2^7 times the angle
  const u64 square = product(a, a);                                          // 2^14 times its square
  u64 series = short_part(120) - (product(short_part(5040), square) >> 14);
  series = short_part(6) - (product(series, square) >> 14);
  const u64 bent = a - (product(a, product(square, series)) >> 14);  // 2^7 sin
  const u64 versed = short_part(24) - (product(short_part(720), square) >> 14);
  const u64 fall = (square >> 1) - (product(square, product(square, versed)) >> 14);  // 2^14 (1 - cos)
  const u64 s = high(tables::sines[cell]), c = high(tables::sines[128 - cell]);
  const u64 s_across = product(c, bent) >> 7, c_across = product(s, bent) >> 7;
  const u64 s_along = s - (product(s, fall) >> 14), c_along = c - (product(c, fall) >> 14);
  const u64 sine = below ? s_along - s_across : s_along + s_across;
  const u64 cosine = below ? c_along + c_across : c_along - c_across;
  const bool swapped = quarter & 1;
  return {.sine = swapped ? cosine : sine,
          .cosine = swapped ? sine : cosine,
          .sine_negative = (quarter >> 1 & 1) != bits >> 63,
          .cosine_negative = ((quarter + 1) >> 1 & 1) != 0};
}

/// The nearest double, if the error cannot change it; otherwise 0.
inline double sure(u64 size, bool negative) {
  const int zeros = std::countl_zero(size | 1);
  const u64 n = size << zeros, error = u64{4} << zeros;
  const bool known = zeros < 8 && (n & 0x7ff) - 0x400 + error > 2 * error;
  const u64 bits = (static_cast<u64>(1022 - zeros) << 52) + (n >> 11) + (n >> 10 & 1);
  return known ? std::bit_cast<double>(bits | static_cast<u64>(negative) << 63) : 0;
}

/// The double nearest to the tangent, if the errors cannot change it; otherwise 0.
inline double sure_tangent(const QuickAngle& angle) {
  const int sine_zeros = std::countl_zero(angle.sine | 1), cosine_zeros = std::countl_zero(angle.cosine | 1);
  if (sine_zeros > 8 || cosine_zeros > 8) return 0;
  const u64 sine = angle.sine << sine_zeros, cosine = angle.cosine << cosine_zeros;
  const u64 quotient = static_cast<u64>((static_cast<u128>(sine) << 63) / cosine);  // 2^62 to 2^64
  const int zeros = std::countl_zero(quotient);
  // |d(s/c)| <= (ds + s/c dc) / c, where s/c < 2
  const double bound = 4 * (0x1p63 / static_cast<double>(cosine)) * ((1 << sine_zeros) + (2 << cosine_zeros));
  const u64 n = quotient << zeros, error = (static_cast<u64>(bound) + 4) << zeros;
  if ((n & 0x7ff) - 0x400 + error <= 2 * error) return 0;
  const auto exponent = static_cast<u64>(1022 - zeros + cosine_zeros - sine_zeros);
  const u64 bits = (exponent << 52) + (n >> 11) + (n >> 10 & 1);
  const bool negative = angle.sine_negative != angle.cosine_negative;
  return std::bit_cast<double>(bits | static_cast<u64>(negative) << 63);
}

}  // namespace flyrock::wide
