#pragma once
// The rows of a point, read in passes. They stay on disk and only one chunk at a time is in memory, so a
// million rocks take no more memory than a thousand.

#include <functional>

#include "record/records.h"

namespace flyrock {

/// The part of each chunk that a pass reads.
enum class Part {
  brief,  ///< rocks, gates, barriers, trees, totals without envelopes and maps; the other tables, which are
          ///< long, are empty
  whole   ///< also inputs, impacts, trajectories, shapes, fixtures, series, envelopes, maps
};

using SeeRows = std::function<void(const TrialRecords& chunk)>;

/// Shows the chunks of a point in the order of their trials. A trial is never split, and every pass shows the
/// same rows. The chunk is destroyed when `see` returns. Throws FileError if a chunk cannot be read.
using Rows = std::function<void(Part part, const SeeRows& see)>;

/// Rows that are already in memory, as one chunk.
Rows rows_of(TrialRecords records);

/// Passes over the rows until `reader` needs no more. It has add(const TrialRecords&), called for each chunk,
/// and bool needs_another_pass(), called after each pass, which says whether it needs another pass.
template <class Reader>
void read_in_passes(const Rows& rows, Reader& reader, Part part = Part::brief) {
  do {
    rows(part, [&](const TrialRecords& chunk) { reader.add(chunk); });
  } while (reader.needs_another_pass());
}

}  // namespace flyrock
