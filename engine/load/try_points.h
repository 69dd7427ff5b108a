#pragma once
// Tries out a loaded scenario: every point of its sweep.

#include <cstdint>

#include "load/load.h"

namespace flyrock {

/// The number of trials of each point that `check` tries out, and `run` before it starts.
inline constexpr std::uint64_t tried_trials = 200;

/// Tries out up to `trials` trials of each point. A failure is reported as an error at the key that caused
/// it. Warnings and notes (`tiers`, `pile_cost`, `deformable`) are added to the scenario.
void try_points(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics);

}  // namespace flyrock
