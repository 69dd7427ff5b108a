#pragma once
// The loads of a scenario that change over time, as a run applies them.

#include "flight/loads.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The scenario must outlive the tables.
LoadTables load_tables_of(const Scenario& scenario);

}  // namespace flyrock
