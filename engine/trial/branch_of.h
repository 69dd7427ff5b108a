#pragma once
// Which branch a hole of a trial takes.

#include "scenario/scenario.h"

namespace flyrock {

/// The branch of all holes of a trial: an index into branch_names(); 0 if no branch of a blast happens.
int branch_of_blast(const Scenario& scenario, std::uint64_t trial);

/// The branch of a hole (from 0) of a trial. Branches are exclusive, so a hole of a blast that takes a branch
/// takes that one. In the other blasts, a branch of a hole of probability p happens with p / (1 - P), where P
/// is the sum of the probabilities of the branches of blasts: of all holes of all trials it is p.
int branch_of_hole(const Scenario& scenario, std::uint64_t trial, std::uint64_t hole);

}  // namespace flyrock
