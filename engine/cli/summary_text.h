#pragma once
// The summary of a run in the terminal.

#include <string>
#include <vector>

#include "results/results.h"
#include "scenario/plan.h"

namespace flyrock::cli {

/// Answer, percentiles by point and group, how the rocks ended, expectations, and the warnings that are not
/// in `told`.
std::string summary_text(const Plan& plan, const Results& results, const std::vector<std::string>& told);

/// One line for each rock of a replayed trial.
std::string trial_text(const Scenario& scenario, const std::vector<RockRecord>& rocks);

}  // namespace flyrock::cli
