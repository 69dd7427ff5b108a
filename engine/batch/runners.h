#pragma once
// What runs the trials of a scenario, one for each point of its sweep.

#include <cstdint>
#include <memory>
#include <vector>

#include "batch/load.h"
#include "batch/trial.h"

namespace flyrock {

using Runners = std::vector<std::unique_ptr<TrialRunner>>;

/// Throws ScenarioError where a plugin cannot be made.
Runners make_runners(const Plan& plan);

/// Trials that a run tries out before it starts.
inline constexpr std::uint64_t tried_before_a_run = 3;

/// Tries each point out on up to `trials` trials and makes its runner; none where there are errors. What
/// fails is an error at the key to blame, and warnings are also those of the scenario.
Runners try_runners(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics);

}  // namespace flyrock
