#pragma once
// Checks whether records from a file fit their scenario. A checksum finds damage. This check finds wrong
// numbers from a program that is not flyrock, because later code uses them as indices.

#include <string>

#include "batch/chunk.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Why the records do not fit: "a rock of group 7, the scenario has 2". Empty if they do.
std::string records_fault(const TrialRecords& records, const ChunkRange& range, const Scenario& scenario);

}  // namespace flyrock
