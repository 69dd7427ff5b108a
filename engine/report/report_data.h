#pragma once
// What report.js draws, as JSON. Lengths are whole millimetres, times whole milliseconds, which keeps the page
// small; series that grow are stored as differences.

#include <nlohmann/json.hpp>

#include "batch/results.h"

namespace flyrock {

/// `rows` of each point are read in passes.
/// { summary, scenario, groups, points: [{ terrain, tracks, runout }], bodies }
nlohmann::ordered_json report_data(const Plan& plan, const Results& results, const std::vector<Rows>& rows);

}  // namespace flyrock
