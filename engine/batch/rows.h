#pragma once
// The rows of a point, read in passes. They stay on disk; in memory is one chunk at a time, so that a million
// rocks take no more of it than a thousand.

#include <functional>

#include "batch/records.h"

namespace flyrock {

/// What a pass reads of each chunk.
enum class Part {
  brief,  ///< rocks, gates, barriers, totals but envelopes; the other tables, which are long, are empty
  whole   ///< and inputs, impacts, trajectories, envelopes
};

using SeeRows = std::function<void(const TrialRecords& chunk)>;

/// Shows the chunks of a point in the order of their trials; a trial is never split, and every pass shows the
/// same. The chunk is gone when `see` returns. Throws FileError where a chunk cannot be read.
using Rows = std::function<void(Part part, const SeeRows& see)>;

/// Rows that are in memory, as one chunk.
Rows rows_of(TrialRecords records);

/// Passes over the rows until `reader` has seen enough. It has see(const TrialRecords&), called for each
/// chunk, and bool again(), called after each pass: whether it needs another one.
template <class Reader>
void read_in_passes(const Rows& rows, Reader& reader, Part part = Part::brief) {
  do {
    rows(part, [&](const TrialRecords& chunk) { reader.see(chunk); });
  } while (reader.again());
}

}  // namespace flyrock
