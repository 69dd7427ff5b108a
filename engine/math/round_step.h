#pragma once
// Bin widths that are easy to read.

#include <cmath>
#include <limits>

namespace flyrock {

/// The smallest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that is not below `width`; 1 if `width` is not
/// positive, or so small that its power of ten may be 0.
inline double round_step(double width) {
  if (!(width >= std::numeric_limits<double>::min())) return 1;
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= width) return step * power;
  return 10 * power;
}

}  // namespace flyrock
