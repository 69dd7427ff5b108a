#pragma once
// The error function and the gamma function of 128-bit numbers, by plain series, because flyrock rarely calls
// them. Relative errors are below 2^-84, except for log_gamma (see there).

#include "math/wide_angle.h"
#include "math/wide_exp_log.h"

namespace flyrock::wide {

inline constexpr Wide two_over_root_pi{join(0x906eba8214db688d, 0x71d48a7f6bfec344), 0};
inline constexpr Wide half_log2_two_pi{join(0xa9b21cd26377dd6c, 0x36cb93c202a2389d), 0};

/// e^(-x^2)
inline Wide bell(const Wide& x) { return exp2(-(x * x * log2_e)); }

/// erf(x) = 2/sqrt(pi) e^(-x^2) (x + 2 x^3 / 3 + 4 x^5 / (3 5) + ...), 0 < x < 7: all terms are positive.
inline Wide erf(const Wide& x) {
  const Wide double_square = scaled(x * x, 1);
  Wide sum = x, term = x;
  for (int n = 3; term.exponent > sum.exponent - 125; n += 2) {
    term = term * double_square * one_over(n);
    sum = sum + term;
  }
  return two_over_root_pi * bell(x) * sum;
}

/// 1 - erf(x), 1.5 < x < 30: its continued fraction e^(-x^2) / sqrt(pi) / (x + (1/2) / (x + (2/2) / (x +
/// (3/2) / ...))).
inline Wide erfc(const Wide& x) {
  const double size = narrow(x);
  Wide fraction = x;
  for (int n = 16 + static_cast<int>(800 / (size * size)); n > 0; --n)
    fraction = x + scaled(integer(n), -1) / fraction;
  return scaled(two_over_root_pi, -1) * bell(x) / fraction;
}

/// log2 of Gamma(x) for x >= 32 by Stirling's series.
inline Wide log2_stirling(const Wide& x) {
  constexpr long long bernoulli[][2] = {
      {1, 12},  {-1, 360},       {1, 1260},       {-1, 1680},        {1, 1188},     {-691, 360360},
      {1, 156}, {-3617, 122400}, {43867, 244188}, {-174611, 125400}, {77683, 5796}, {-236364091, 1506960}};
  const Wide inverse_x = inverse(x), inverse_square = inverse_x * inverse_x;
  Wide sum, power = inverse_x;
  for (const auto& [above, below] : bernoulli) {
    sum = sum + power * integer(above) / integer(below);
    power = power * inverse_square;
  }
  return (x - scaled(integer(1), -1)) * log2(x) + (sum - x) * log2_e + half_log2_two_pi;
}

/// Gamma(x) = 2^(log2 Gamma(x + n)) / (x (x + 1) ... (x + n - 1)), x > 0.
struct Rising {
  Wide log2_gamma;  ///< of x + n >= 32
  Wide product = integer(1);
};
inline Rising rising(Wide x) {
  Rising parts;
  for (; x.exponent < 5; x = x + integer(1)) parts.product = parts.product * x;
  parts.log2_gamma = log2_stirling(x);
  return parts;
}

/// Gamma(x), 0 < x < 200.
inline Wide gamma(const Wide& x) {
  const Rising parts = rising(x);
  return exp2(parts.log2_gamma) / parts.product;
}

/// ln Gamma(1 + z) for |z| < 2^-12, by its Taylor series with the coefficients zeta(n) / n.
inline Wide log_gamma_near_one(const Wide& z) {
  constexpr Wide coefficients[] = {
      {join(0x9381d0ee751d72c6, 0x0ffa0f2958701a44), -3, true},
      {join(0xada06588061830a5, 0x3cca078ab4ad8efb), -3, false},
      {join(0xd45ce0bd530a492e, 0x826a4fdae19904dc), -3, true},
      {join(0x8a8991563ec241b5, 0xf91211196e5235fc), -2, false},
      {join(0xcd26aadf5596b7ac, 0xf64b92e699b5aa12), -2, true},
      {join(0xd28d3312983e9918, 0x73d8912200bace5f), -1, false},
      {join(0x93c467e37db0c7a4, 0xd1be3f810152cb57), -1, true}};  // the last: Euler's gamma
  Wide sum;
  for (const Wide& coefficient : coefficients) sum = sum * z + coefficient;
  return sum * z;
}

/// ln Gamma(x), x > 0, to full precision, including near its roots 1 and 2.
inline Wide log_gamma(const Wide& x) {
  const Wide above_one = x - integer(1), above_two = x - integer(2);
  if (above_one.mantissa == 0 || above_two.mantissa == 0) return {};
  if (above_one.exponent < -12) return log_gamma_near_one(above_one);
  if (above_two.exponent < -12) return log_gamma_near_one(above_two) + log1p(above_two);
  const Rising parts = rising(x);
  return (parts.log2_gamma - log2(parts.product)) * ln2;
}

/// sin(pi x)
inline Wide sine_of_pi_times(double x) {
  const double nearest = std::nearbyint(x), quarters = 2 * std::fabs(x - nearest);  // 0 to 1, exact
  const int cell = static_cast<int>(quarters * 128 + 0.5);
  Wide size = sine({.cell = cell, .rest = widen(quarters - cell / 128.0) * half_pi});
  size.negative = (x < nearest) != (std::fmod(nearest, 2) != 0);
  return size;
}

}  // namespace flyrock::wide
