#pragma once
// Measures of a contact over time: contact.<a>.<b>.<quantity>.<mean|max|min|final|at[time]>.

#include <string>
#include <vector>

#include "record/series.h"
#include "results/measured/over_steps.h"

namespace flyrock {

struct ContactMeasure {
  std::string a, b;      ///< bodies, in any order; `terrain` is all of it
  std::string quantity;  ///< gap, un, ut, rn, rt
  OverSteps over;

  /// Over the steps of a series. Forces are sums over the points of the pair, the other quantities are those
  /// of the point with the least gap.
  OverSteps::Answer value(const std::vector<SeriesContact>& rows) const;
};

}  // namespace flyrock
