#pragma once
// The gap between two balls along a parabola.

#include <array>

#include "collision/motion.h"

namespace flyrock {

/// (|x(t)|^2 - r^2) / 2 r for the path of one centre relative to the other, r the sum of the radii: near
/// contact the gap itself, and a polynomial of degree 4. `gap` is what the gap counts as at t = 0, |x| - r or
/// a correction of it.
template <int D>
std::array<double, 5> ball_gap(const Path<D>& relative, double r, double gap) {
  const auto& [x, v, a] = relative;
  const double scale = 0.5 / r;
  return {gap * (x.norm() + r) * scale, 2 * x.dot(v) * scale, (v.squaredNorm() + x.dot(a)) * scale,
          v.dot(a) * scale, 0.25 * a.squaredNorm() * scale};
}

}  // namespace flyrock
