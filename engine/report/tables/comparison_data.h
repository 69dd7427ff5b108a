#pragma once
// How the points of a sweep compare, for summary.json.

#include <nlohmann/json.hpp>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// [{ point, against: 0, reason, groups: [{ group, unpaired, numbers: { runout: { unit, mean, interval,
/// design_effect, trials_needed, pairs, censored, differing_trials } } }] }]
nlohmann::ordered_json differences_data(const Plan& plan, const Results& results);

/// { least, unit, such_that: [{ measure, below, above, unit }], best: [point], points: [{ point, holds,
/// least: { value, interval, lower_bound, reason }, such_that: [{ ..., holds, short_by }], short }] }
nlohmann::ordered_json best_point_data(const Plan& plan, const BestPoint& best);

}  // namespace flyrock
