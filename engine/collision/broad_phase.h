#pragma once
// Broad phase: which bodies may meet, by sort and sweep along x.

#include <utility>
#include <vector>

#include "collision/motion.h"

namespace flyrock {

class SortAndSweep {
 public:
  /// The pairs (i < j) of boxes that overlap, sorted. The order along x is kept between calls, because
  /// sorting is then cheap as long as the boxes move little.
  template <int D>
  const std::vector<std::pair<int, int>>& pairs(const std::vector<Box<D>>& boxes);

 private:
  std::vector<int> order_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace flyrock
