#pragma once
// A deformable body at the instant when it is stressed most.

#include <vector>

#include "record/records.h"

namespace flyrock {

/// By is_stressed_more (record/series.h).
struct StressedBlock {
  SeriesStress at;
  std::vector<SeriesNode> nodes;
  std::vector<SeriesCell> cells;
};

/// The deformable bodies of the first trial of a chunk with series, in the order of their rows.
std::vector<StressedBlock> most_stressed(const TrialRecords& chunk);

}  // namespace flyrock
