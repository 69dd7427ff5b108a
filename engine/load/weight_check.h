#pragma once
// Warns of weights with which probabilities per blast do not tell.

#include "document/diagnostics.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Plan;
struct Value;

/// A weight from which on the bounds of a probability may lie apart by more than a factor of 1.2
/// (results/statistics/blast_bounds.h): they lie apart by up to the weight.
inline constexpr double harmless_weight = 1.2;

/// A warning at each group whose rocks stand for so many real ones, where the scenario asks for a probability
/// per blast: a gate, a barrier, an exposure, a clearance `per: blast`. Errors of plugins met here are left
/// to the run to report.
void warn_of_weights(const Value& root, const Plan& plan, Diagnostics& diagnostics);

}  // namespace flyrock
