#pragma once
// Bin widths that are easy to read.

#include <cmath>

namespace flyrock {

/// The smallest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that is not below `width`; 1 if `width` is not
/// positive.
inline double round_step(double width) {
  if (!(width > 0)) return 1;
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= width) return step * power;
  return 10 * power;
}

}  // namespace flyrock
