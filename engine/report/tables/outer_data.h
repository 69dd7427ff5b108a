#pragma once
// The scatter between the runs of a point (`outer`), for summary.json and the report.

#include <nlohmann/json_fwd.hpp>

#include "results/measured/outer.h"

namespace flyrock {

/// { runs, trials, lost, numbers: { MEASURE: { unit, runs, mean, sd, min, p5, p50, p95, max, lower_bounds:
/// [...] } } }: of each measure, over the runs that give it. `lower_bounds` names the statistics that are
/// bounds.
nlohmann::ordered_json outer_data(const OuterSummary& outer);

}  // namespace flyrock
