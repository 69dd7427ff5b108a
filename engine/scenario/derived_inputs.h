#pragma once
// The derived numbers of a blast (blast/derived.h) in a scenario: which given numbers each is made of, and
// whether it differs from rock to rock.

#include <string>
#include <vector>

#include "blast/derived.h"
#include "scenario/scenario.h"

namespace flyrock {

/// "derived.powder_factor"
std::string path_of(Derived derived);

/// The given fields that a derived number is made of, of the blast or of measured holes.
std::vector<BlastField> made_of(const BlastPlan& blast, Derived derived);

/// Their paths, with what is scattered: "blast.burden", "blast.scatter.burden".
std::vector<std::string> paths_made_of(const BlastPlan& blast, Derived derived);

/// Whether a number differs between holes, trials or branches.
bool differs(const Scenario& scenario, Derived derived);

/// The numbers of each hole with the medians of all distributions; of a pattern of rows too.
std::vector<DerivedNumbers> typical_of_holes(const BlastPlan& blast);

/// The numbers of the whole blast, with the medians of all distributions.
DerivedNumbers typical_derived(const BlastPlan& blast);

}  // namespace flyrock
