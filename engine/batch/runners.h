#pragma once
// The runners of the trials of a scenario, one for each point of its sweep.

#include <cstdint>
#include <memory>
#include <vector>

#include "batch/trial.h"
#include "load/load.h"

namespace flyrock {

using Runners = std::vector<std::unique_ptr<TrialRunner>>;

/// Throws ScenarioError if a plugin cannot be made.
Runners make_runners(const Plan& plan);

/// Tries out up to `trials` trials of each point (load/try_points.h) and makes its runner; none if there are
/// errors.
Runners try_runners(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics);

}  // namespace flyrock
