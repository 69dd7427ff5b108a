#pragma once
// The blast at one hole.

#include "scenario/scenario.h"

namespace flyrock {

/// The blast of a scenario at the hole of `key`, with its draws and completed. All fields are NaN if the
/// scenario has no blast. Throws ScenarioError if the draws leave no charge, stemming or burden.
Blast blast_at(const Scenario& scenario, const DrawKey& key);

/// When the hole of a key goes off [s], with its scatter.
double time_of_hole(const Scenario& scenario, const DrawKey& key);

/// The index of the hole of a key, from 0. In keys, holes count from 1 and 0 means no hole.
inline int hole_of(const DrawKey& key) { return key.hole == 0 ? 0 : static_cast<int>(key.hole) - 1; }

}  // namespace flyrock
