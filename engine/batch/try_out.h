#pragma once
// Finds failures before a scenario runs: calls its laws on sampled states and makes its first trials.

#include <cstdint>
#include <vector>

#include "scenario/scenario.h"
#include "trial/scenario_error.h"

namespace flyrock {

/// The findings for a point of a plan. For each key the first one, with its trial and rock.
struct TriedOut {
  std::vector<ScenarioError> errors;  ///< bad input
  std::vector<ScenarioError> warnings;
};

/// Calls each law of a point of a plan on three sampled states. Makes (but does not run) up to `trials`
/// trials: at least one, and none after 2000 rocks.
TriedOut try_out(const Scenario& scenario, std::uint64_t trials);

}  // namespace flyrock
