#pragma once
// The end of a run in the terminal.

#include <string>

#include "batch/results.h"

namespace flyrock::cli {

/// Answer, percentiles by point and group, what the rest did, expectations, warnings.
std::string summary_text(const Plan& plan, const Results& results);

/// Each rock of a replayed trial in a line.
std::string trial_text(const Scenario& scenario, const TrialRecords& records);

}  // namespace flyrock::cli
