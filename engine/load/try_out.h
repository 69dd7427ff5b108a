#pragma once
// Finds failures before a scenario runs: calls its laws on sampled states and makes its first trials.

#include <cstdint>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "trial/scenario_error.h"

namespace flyrock {

/// The findings for a point of a plan. For each key the first one, with its trial and rock.
struct TriedOut {
  std::vector<ScenarioError> errors;  ///< bad input
  std::vector<ScenarioError> warnings;
  std::string tiers;       ///< tier_note of the first trial that has one
  std::string pile_cost;   ///< pile_cost_note of the first trial that has one
  std::string deformable;  ///< deformable_note of the first trial that has one
};

/// How much of a point is tried, counted and not timed: `check` and `run` on every machine ask the same.
struct TryLimits {
  std::uint64_t trials = 200;
  std::size_t rocks = 2000;
  std::size_t ground = 100'000'000;  ///< bytes of grounds that are another one in each trial
};

/// Calls each law of a point of a plan on three sampled states. Makes (but does not run) trials: at least
/// one, and no further one once a limit is reached.
TriedOut try_out(const Scenario& scenario, const TryLimits& limits);

}  // namespace flyrock
