#pragma once
// Whether a run is long enough for the clearances that it is asked for.

#include <cstdint>

#include "document/diagnostics.h"
#include "scenario/scenario.h"

namespace flyrock {

/// A clearance needs so many rocks (or blasts) that 10 of them are expected beyond it: fewer say too little
/// about the tail.
std::uint64_t needed_for(double probability);

/// Rocks of a blast below which its farthest says little: a blast throws thousands.
inline constexpr std::uint64_t few_rocks_per_blast = 100;

/// At any point of the sweep: an error at each clearance of the scenario's tree that its rocks and trials are
/// too few for, where the run is a `full` one; a warning at each `per: blast` with few rocks a blast. What a
/// plugin does wrong meanwhile is left to the run to report.
void check_clearances(const Value& root, const Plan& plan, bool full, Diagnostics& diagnostics);

}  // namespace flyrock
