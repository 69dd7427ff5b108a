#pragma once
// `sampling`: a design of trials (random/sampling.h) covers the draws of which each trial has one.

#include "document/node.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Gives each draw that the design covers its coordinate, in the order of the names of streams. A trial has
/// one number of a draw `per: trial`; of one `per: rock` if its group (without a group: the scenario) has one
/// rock in each trial; of one `per: hole` if the blast has one hole. All others stay random. `root`: the
/// normalised document. Reports a number of trials that the design does not take, and what has no interval
/// without independent trials: clearances, `outer`, comparisons with measurements.
void cover_draws(const Node& root, Scenario& scenario, Diagnostics& diagnostics);

/// The trials that are one independent unit: a replicate of a design, else one.
std::uint64_t trials_of_unit(const Scenario& scenario);

/// The same coordinates for the draws of a branch.
void cover_alike(const Scenario& regular, Scenario& branch);

}  // namespace flyrock
