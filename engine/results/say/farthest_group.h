#pragma once
// The group of rocks that answers and pages begin with.

#include <cmath>
#include <vector>

#include "results/results.h"

namespace flyrock {

/// The group with the farthest rock, by its place in PointResult::groups; 0, all rocks, where there is one
/// group only.
inline std::size_t farthest_group(const std::vector<GroupSummary>& groups) {
  const auto greatest = [&](std::size_t g) {
    return groups[g].at(rock_statistic("runout"), Statistic::max).value;
  };
  std::size_t farthest = groups.size() > 1 ? 1 : 0;
  for (std::size_t g = 2; g < groups.size(); ++g)
    if (greatest(g) > greatest(farthest) || std::isnan(greatest(farthest))) farthest = g;
  return farthest;
}

}  // namespace flyrock
