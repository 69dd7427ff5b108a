#pragma once
// The runners of the trials of a scenario, one for each point of its sweep.

#include <cstdint>
#include <memory>
#include <vector>

#include "batch/load.h"
#include "batch/trial.h"

namespace flyrock {

using Runners = std::vector<std::unique_ptr<TrialRunner>>;

/// Throws ScenarioError if a plugin cannot be made.
Runners make_runners(const Plan& plan);

/// The number of trials of each point that `check` tries out, and `run` before it starts.
inline constexpr std::uint64_t tried_trials = 200;

/// Tries out up to `trials` trials of each point and makes its runner; none if there are errors. A failure is
/// reported as an error at the key that caused it. The warnings are also added to the scenario.
Runners try_runners(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics);

}  // namespace flyrock
