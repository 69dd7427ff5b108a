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

}  // namespace flyrock
