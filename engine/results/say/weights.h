#pragma once
// Whether the rocks of a run have weights, and what weights mean for its numbers.

#include <algorithm>

#include "results/results.h"
#include "scenario/plan.h"

namespace flyrock {

/// A weight is the number of real rocks that a rock stands for: the scenario gives it to a group, or a
/// population answers it. Then numbers over several groups are weighted. Without weights they depend on how
/// many rocks of each group were run: texts and tables give each group and no mixture.
inline bool has_weights(const Plan& plan, const Results& results) {
  return std::any_of(plan.points.begin(), plan.points.end(),
                     [](const Scenario& point) { return point.gives_weights(); }) ||
         std::any_of(results.points.begin(), results.points.end(),
                     [](const PointResult& point) { return point.groups.front().weights.any(); });
}

inline constexpr const char* meaning_of_weights =
    "Rocks have weights, the number of real rocks that each stands for: numbers over several groups are "
    "weighted. The rocks of a blast share its draws, so the probability that at least one real rock does "
    "something is known between bounds; the upper one is given, and both where they lie apart by more than "
    "a factor of 1.2.";

/// The groups that tables show, by their places in PointResult::groups: without weights each of several
/// groups, else all rocks too.
inline std::size_t first_shown_group(const Plan& plan, const Results& results) {
  return results.points.front().groups.size() > 1 && !has_weights(plan, results) ? 1 : 0;
}

}  // namespace flyrock
