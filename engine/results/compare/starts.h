#pragma once
// Where the measured rocks start, before any of them flies.

#include <cstdint>

#include "results/compare/simulated_rows.h"

namespace flyrock {

/// The rows of the first trials of a scenario with `observed`: their starts, from which measured places
/// count, and no paths. Throws ScenarioError if a trial cannot be built.
SimulatedRows starts_of(const Scenario& scenario, std::uint64_t trials);

}  // namespace flyrock
