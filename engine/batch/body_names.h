#pragma once
// What the bodies of a trial are called in results.

#include "flight/world_names.h"
#include "scenario/scenario.h"
#include "trial/build_trial.h"

namespace flyrock {

/// The names in a world of a trial. Rocks are called by their group and their number in the trial: "blocks
/// 3". Instantiated for D = 2, 3.
template <int D>
WorldNames names_of(const Scenario& scenario, const Trial<D>& trial, int world);

}  // namespace flyrock
