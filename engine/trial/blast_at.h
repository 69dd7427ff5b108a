#pragma once
// The blast of one hole.

#include "scenario/scenario.h"

namespace flyrock {

/// The blast of a scenario at `key`, drawn and completed; all fields NaN where there is none. Throws
/// ScenarioError where the draws leave no charge, stemming or burden.
Blast blast_at(const Scenario& scenario, const DrawKey& key);

/// The hole of a key, from 0; holes of keys count from 1, 0 being no hole.
inline int hole_of(const DrawKey& key) { return key.hole == 0 ? 0 : static_cast<int>(key.hole) - 1; }

}  // namespace flyrock
