#pragma once
// With which speed a driven body approaches at a contact, apart from rounding.

#include <cmath>

namespace flyrock {

/// The speed of approach along the normal [m/s] of a driven body that moves there with `speed`. A body that
/// moves along its contact, as the wall of a drum that turns, approaches by rounding only: 0.
inline double driven_approach_beyond_rounding(double approach, double speed) {
  constexpr double rounding = 1e-6;  // of the speed
  return std::abs(approach) <= rounding * speed ? 0 : approach;
}

}  // namespace flyrock
