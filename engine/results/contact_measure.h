#pragma once
// Measures of a contact over time: contact.<a>.<b>.<quantity>.<mean|max|min|final|at[time]>.

#include <string>
#include <vector>

#include "record/series.h"

namespace flyrock {

struct ContactMeasure {
  std::string a, b;      ///< bodies, in any order; `terrain` is all of it
  std::string quantity;  ///< gap, un, ut, rn, rt
  std::string of_time;   ///< mean, max, min, final, at
  double time = 0;       ///< s, for `at`

  struct Answer {
    double value = 0;
    std::string fault;  ///< why there is no value
  };
  /// Over the steps of a series. Forces are sums over the points of the pair, the other quantities are those
  /// of the point with the least gap. The mean counts each step with its length. `at` is the step that
  /// contains the time.
  Answer value(const std::vector<SeriesContact>& rows) const;
};

}  // namespace flyrock
