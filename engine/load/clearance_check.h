#pragma once
// Checks whether a run is long enough for the clearances of its scenario.

#include <cstdint>

#include "document/diagnostics.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Plan;
struct Value;

/// The number of rocks (or blasts) that a clearance needs: so many that 10 of them are expected beyond it.
/// Fewer say too little about the tail.
std::uint64_t needed_for(double probability);

/// With fewer rocks in a blast, the farthest one says little, because a real blast throws thousands.
inline constexpr std::uint64_t few_rocks_per_blast = 100;

/// Checks all points of the sweep. Reports an error at each clearance that has too few rocks and trials, if
/// the run is a `full` one, and a warning at each `per: blast` with few rocks in a blast. Errors of plugins
/// met here are left to the run to report.
void check_clearances(const Value& root, const Plan& plan, bool full, Diagnostics& diagnostics);

}  // namespace flyrock
