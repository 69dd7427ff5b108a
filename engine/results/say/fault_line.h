#pragma once
// The first line of a report in which rocks diverged or failed.

#include <string>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// "2 of 4000 rocks diverged: below the ground (trial 17, rock 0). They are in no number of this report:
/// ..."; empty if no rock failed.
std::string fault_line(const Plan& plan, const Results& results);

}  // namespace flyrock
