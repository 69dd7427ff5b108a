#pragma once
// What can be known to fail before a scenario runs: its laws on sampled states, its first trials as they are
// made.

#include <cstdint>
#include <vector>

#include "scenario/scenario.h"
#include "trial/scenario_error.h"

namespace flyrock {

/// What a point of a plan shows before it runs. Of each key the first, with its trial and rock.
struct TriedOut {
  std::vector<ScenarioError> errors;  ///< bad input
  std::vector<ScenarioError> warnings;
};

/// Calls each law of a point of a plan on three sampled states, and makes (does not run) up to `trials`
/// trials, at least one, but no more after 2000 rocks.
TriedOut try_out(const Scenario& scenario, std::uint64_t trials);

}  // namespace flyrock
