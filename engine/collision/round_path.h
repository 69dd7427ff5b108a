#pragma once
// The gap between two balls along a parabola.

#include <array>

#include "collision/motion.h"

namespace flyrock {

/// The coefficients of (|x(t)|^2 - r^2) / (2 r) [m], for the path x(t) of one centre relative to the other
/// and the sum r of the radii. This is a polynomial of degree 4 that equals the gap to first order near
/// contact. `gap` [m] is the gap at t = 0: |x| - r, or a corrected value.
template <int D>
std::array<double, 5> ball_gap(const Path<D>& relative, double r, double gap) {
  const auto& [x, v, a] = relative;
  const double scale = 0.5 / r;
  return {gap * (x.norm() + r) * scale, 2 * x.dot(v) * scale, (v.squaredNorm() + x.dot(a)) * scale,
          v.dot(a) * scale, 0.25 * a.squaredNorm() * scale};
}

/// The same where the sum of the radii is r + swell' t + swell'' t^2 / 2, in (|x(t)|^2 - r(t)^2) / (2 r).
template <int D>
std::array<double, 5> ball_gap(const Path<D>& relative, double r, const Swell& swell, double gap) {
  std::array<double, 5> square = ball_gap(relative, r, gap);
  const double r1 = swell.rate, r2 = 0.5 * swell.growth, scale = 0.5 / r;
  square[1] -= 2 * r * r1 * scale;
  square[2] -= (r1 * r1 + 2 * r * r2) * scale;
  square[3] -= 2 * r1 * r2 * scale;
  square[4] -= r2 * r2 * scale;
  return square;
}

}  // namespace flyrock
