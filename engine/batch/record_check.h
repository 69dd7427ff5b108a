#pragma once
// Whether records that were read fit the scenario that they are said to be of. A checksum finds damage; this
// finds what a program that is not flyrock has written: numbers that later code uses as indices.

#include <string>

#include "batch/chunk.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Why they do not fit: "a rock of group 7, the scenario has 2". Empty where they do.
std::string records_fault(const TrialRecords& records, const ChunkRange& range, const Scenario& scenario);

}  // namespace flyrock
