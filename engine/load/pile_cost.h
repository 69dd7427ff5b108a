#pragma once
// Says what a trial costs in which many bodies may pile up.

#include <cstddef>
#include <string>

#include "scenario/scenario.h"

namespace flyrock {

/// One line with the processor time that a trial of `bodies` that may meet takes at most, if they pile up and
/// move until stop.time. Empty where it is below a minute. Measured: a body costs 25 us a dense step in 2D,
/// 0.13 ms in 3D (docs/numerics.md); piles that come to rest end earlier. With
/// `solver.bodies: exact` no time is known, and the line says so.
std::string pile_cost_note(const Scenario& scenario, std::size_t bodies);

}  // namespace flyrock
