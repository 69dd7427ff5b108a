#pragma once
// What the scripts of the page draw, as JSON. Lengths are whole millimetres, times whole milliseconds, which keeps the
// page small; series that grow are stored as differences.

#include <nlohmann/json.hpp>

#include "batch/load.h"
#include "batch/results.h"

namespace flyrock {

/// `rows` of each point are read in passes; the laws of the scenario are sampled (call it in the thread of its session).
/// { summary, source: { sha256, plugins }, scenario, groups, units, drawn, points: [{ terrain, tracks, runout,
/// convergence, envelopes, sensitivity, laws, bodies }] }. `laws` is null where it is that of point 0.
nlohmann::ordered_json report_data(const LoadedScenario& scenario, const Results& results, const std::vector<Rows>& rows);

}  // namespace flyrock
