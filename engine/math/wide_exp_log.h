#pragma once
// 2^x and log2(x) of 128-bit numbers: tables for the leading bits, a short series for the rest. Relative
// errors are below 2^-90 (exp2) and 2^-100 (log2).

#include <array>

#include "math/wide.h"

namespace flyrock::wide {

inline constexpr Wide ln2{join(0xb17217f7d1cf79ab, 0xc9e3b39803f2f6af), -1};
inline constexpr Wide log2_e{join(0xb8aa3b295c17f0bb, 0xbe87fed0691d3e89), 0};
inline constexpr Wide log10_2{join(0x9a209a84fbcff798, 0x8f8959ac0b7c9178), -2};

namespace tables {

/// e^x by its series, for the tables.
constexpr Wide exp_series(const Wide& x) {
  Wide sum = integer(1), term = integer(1);
  for (int n = 1; n < 40; ++n) {
    term = term * x / integer(n);
    sum = sum + term;
  }
  return sum;
}

/// 2^(i / 2^bits) for i < 128, with 127 fractional bits.
constexpr std::array<u128, 128> powers(int bits) {
  std::array<u128, 128> table{};
  for (int i = 0; i < 128; ++i) table[i] = exp_series(scaled(integer(i) * ln2, -bits)).mantissa;
  return table;
}
inline constexpr std::array<u128, 128> coarse_powers = powers(7), fine_powers = powers(14);

/// log2(x) = 2 log2(e) artanh((x - 1) / (x + 1)) by its series, with 116 fractional bits.
constexpr i128 log2_series(const Wide& x) {
  const Wide u = (x - integer(1)) / (x + integer(1));
  Wide sum, power = u;
  for (int n = 1; n < 60; n += 2) {
    sum = sum + power / integer(n);
    power = power * u * u;
  }
  const Wide log = scaled(sum * log2_e, 1);
  const i128 fixed = log.mantissa == 0 ? 0 : static_cast<i128>(log.mantissa >> (11 - log.exponent));
  return log.negative ? -fixed : fixed;
}

struct Cell {
  i128 log;    ///< -log2 of the factor's value
  int factor;  ///< about 1 / x
};

/// For x near i/128, i from 90 to 181: the factor is that over 2^9.
constexpr std::array<Cell, 92> coarse_logs() {
  std::array<Cell, 92> table{};
  for (int i = 90; i <= 181; ++i) {
    const int factor = (2 * 512 * 128 + i) / (2 * i);
    table[i - 90] = {-log2_series(scaled(integer(factor), -9)), factor};
  }
  return table;
}
/// For x near 1 + (i - 128) / 2^14: the factor is 1 + that over 2^22.
constexpr std::array<Cell, 257> fine_logs() {
  std::array<Cell, 257> table{};
  for (int i = 0; i <= 256; ++i) {
    const int step = i - 128;
    const int factor = -step * (1 << 22) / ((1 << 14) + step);
    table[i] = {-log2_series(scaled(integer((1 << 22) + factor), -22)), factor};
  }
  return table;
}
inline constexpr std::array<Cell, 92> coarse = coarse_logs();
inline constexpr std::array<Cell, 257> fine = fine_logs();

}  // namespace tables

/// 2^x for |x| < 2^11.
inline Wide exp2(const Wide& x) {
  if (x.exponent < -116) return integer(1);
  const i128 size = static_cast<i128>(x.mantissa >> (11 - x.exponent));  // 116 fractional bits
  const i128 fixed = x.negative ? -size : size;
  const u128 share = static_cast<u128>(fixed) << 12;
  // 2^share = 2^(i / 2^7) 2^(j / 2^14) e^z, where 2^14 z = rest ln 2
  const u128 rest = share << 14;
  const u128 z = product(rest, ln2.mantissa);  // 2^14 z
  const u64 short_z = high(z);
  u64 series = short_part(24) + (product(short_part(120), short_z) >> 14);
  series = short_part(6) + (product(series, short_z) >> 14);
  series = (u64{1} << 63) + (product(series, short_z) >> 14);
  const u128 growth = (z >> 14) + (full_product(product(short_z, short_z), series) >> 28);  // e^z - 1
  const u64 leading = high(share);
  const u128 power = product(tables::coarse_powers[leading >> 57], tables::fine_powers[leading >> 50 & 127]);
  return normal(power + product(power, growth), 1 + static_cast<int>(fixed >> 116));
}

/// log2(1 + z) for |z| < 2^-14: z times a series.
inline Wide log2_near_one(const Wide& z) {
  constexpr auto coefficient = [](int n) {
    return (log2_e / integer(n)).mantissa >> (-1 - (log2_e / integer(n)).exponent);
  };
  constexpr u128 c2 = coefficient(2), c3 = coefficient(3);
  constexpr u64 c4 = high(coefficient(4)), c5 = high(coefficient(5)), c6 = high(coefficient(6)),
                c7 = high(coefficient(7));
  const u128 a = fraction(z, 14);
  const auto next = [&](auto c, auto term) { return z.negative ? c + (term >> 14) : c - (term >> 14); };
  u64 series = next(c6, product(c7, high(a)));
  series = next(c5, product(series, high(a)));
  series = next(c4, product(series, high(a)));
  const u128 outer = next(c2, product(a, next(c3, product(a, series))));
  return z * Wide{next(log2_e.mantissa, product(a, outer) >> 1), 0, false};
}

/// log2(x) for x > 0.
inline Wide log2(const Wide& x) {
  constexpr u128 root_of_two = join(0xb504f333f9de6484, 0);
  const bool large = x.mantissa > root_of_two;
  const int power = x.exponent + large;
  const u128 m = x.mantissa >> large;  // 0.7 to 1.4, 127 fractional bits
  // Multiply twice by a factor from a table, which leaves 1 + r; here with 126 fractional bits, exact for
  // doubles.
  const tables::Cell& coarse = tables::coarse[static_cast<int>((m + (u128{1} << 119)) >> 120) - 90];
  const i128 r = static_cast<i128>((m >> 10) * coarse.factor) - (i128{1} << 126);
  const tables::Cell& fine = tables::fine[static_cast<int>((r + (i128{1} << 111)) >> 112) + 128];
  const i128 rest = r + (static_cast<i128>(fine.factor) << 104) + (((r >> 16) * fine.factor) >> 6);
  const i128 sum = (static_cast<i128>(power) << 116) + coarse.log + fine.log;
  const Wide tail = log2_near_one(normal(static_cast<u128>(rest < 0 ? -rest : rest), 1, rest < 0));
  return normal(static_cast<u128>(sum < 0 ? -sum : sum), 11, sum < 0) + tail;
}

/// ln(1 + z), z > -1.
inline Wide log1p(const Wide& z) {
  return (z.exponent < -14 ? log2_near_one(z) : log2(integer(1) + z)) * ln2;
}

/// e^x - 1, |x| < 1000.
inline Wide expm1(const Wide& x) {
  if (x.exponent >= -3) return exp2(x * log2_e) - integer(1);
  Wide sum = integer(1);
  for (int n = 20; n > 1; --n) sum = integer(1) + sum * x * one_over(n);
  return x * sum;
}

}  // namespace flyrock::wide
