#pragma once
// What report.js draws, as JSON. Lengths are whole millimetres, times whole milliseconds, which keeps the page
// small; series that grow are stored as differences.

#include <nlohmann/json.hpp>

#include "batch/results.h"

namespace flyrock {

/// The counts of a histogram of runout, the rocks whose runout is known beside those that are censored, and the
/// share of rocks that went farther than x. Both need no more room for a million rocks than for a thousand.
nlohmann::ordered_json runout_data(const std::vector<Bounded>& values);

/// { summary, scenario, groups, points: [{ terrain, tracks, runout }], bodies }
nlohmann::ordered_json report_data(const Plan& plan, const Results& results);

}  // namespace flyrock
