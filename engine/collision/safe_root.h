#pragma once
// The time until a concave bound of a gap is zero.

#include <algorithm>
#include <limits>

#include "collision/safe_time.h"

namespace flyrock {

/// A time until which a concave function stays positive, up to a millionth of it, or forever if that is
/// beyond `end`. A chord of the function lies below it. The line through two of its points lies above it
/// beyond these points. So the root of the chord is a safe time, and the root of the line is a time beyond
/// the root of the function. `slope`: of the function at 0. `counts`: see safe_time.
template <class Function>
double safe_root(const Function& f, double slope, double end, const GapScale& scale, Counts counts) {
  const double start = f(0.0);
  if (start < -scale.deep && counts != Counts::from_zero) return 0;
  if (start <= scale.least && slope < 0) return 0;
  const double base = std::min(start, 0.0);
  const auto g = [&](double t) { return f(t) - (start <= scale.least ? start : base); };
  if (g(end) >= 0) return forever;
  double low = 0, at_low = g(0.0), high = end, at_high = g(end);
  for (int i = 0; i < 60 && !(at_low > 0); ++i) {
    const double t = 0.25 * high, value = g(t);
    if (value > 0)
      low = t, at_low = value;
    else
      high = t, at_high = value;
  }
  if (!(at_low > 0)) return 0;
  for (int i = 0; i < 40 && high - low > 1e-6 * high; ++i) {
    const double t = low + (high - low) * at_low / (at_low - at_high);
    const double value = g(t);
    if (!(value > 0)) {  // a straight line: the chord ends at the root, but for rounding
      const double before = low + (1 - 1e-6) * (t - low);
      if (g(before) > 0) low = before;
      break;
    }
    if (!(t > low)) break;
    const double fall = (at_low - value) / (t - low);
    low = t;
    at_low = value;
    // Where the function still rises, no line tells how far away the root is, and chords creep.
    const double beyond = fall > 0 ? t + value / fall * (1 + 1e-9) : low + 0.25 * (high - low);
    if (beyond >= high) continue;
    const double at_beyond = g(beyond);
    if (at_beyond > 0)
      low = beyond, at_low = at_beyond;
    else
      high = beyond, at_high = at_beyond;
  }
  return low;
}

}  // namespace flyrock
