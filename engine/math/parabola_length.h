#pragma once
// The length of a path with constant acceleration.
//
// The speed is sqrt(p^2 + u^2), where u = u0 + a t is its component along the acceleration and p, which stays
// the same, the one across it. With the speeds s0 and s1 at both ends and S = s0 + s1, U = u0 + u1,
// d = u1 - u0, the integral of the speed over [0, t] is
//   t/4 (S + U^2/S) + p^2/(2a) ln((S + d)/(S - d)).
// Both terms are at least 0, so that no digits cancel. The logarithm is 2 artanh(d/S), which is a short
// series for short times. Source: integral of sqrt(p^2 + u^2), with asinh(u1/p) - asinh(u0/p) = 2
// artanh(d/S).

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

/// artanh(z)/z as a series of its square, for |z| <= 1/8.
inline double artanh_share(double square) {
  double sum = 0;
  for (int k = 8; k >= 0; --k) sum = sum * square + 1.0 / (2 * k + 1);
  return sum;
}

/// The length [m] over the time t >= 0 [s], of p^2 [m2/s2], u0 [m/s] and a >= 0 [m/s2].
inline double parabola_length(double p_squared, double u0, double a, double t) {
  const double d = a * t, u1 = u0 + d;
  const double sum = std::sqrt(p_squared + u0 * u0) + std::sqrt(p_squared + u1 * u1);
  if (!(sum > 0)) return 0;
  const double along = u0 + u1, z = d / sum;
  const double straight = 0.25 * t * (sum + along * along / sum);
  if (z <= 0.125) return straight + p_squared * t / sum * artanh_share(z * z);
  // Rounding can make the difference 0 if p is next to nothing.
  const double left = std::max(sum - d, std::numeric_limits<double>::epsilon() * sum);
  return straight + 0.5 * p_squared / a * std::log((sum + d) / left);
}

}  // namespace flyrock
