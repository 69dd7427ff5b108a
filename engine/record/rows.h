#pragma once
// The rows of a point, read in passes. They stay on disk and only one chunk at a time is in memory, so a
// million rocks take no more memory than a thousand.

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "record/records.h"

namespace flyrock {

/// The part of each chunk that a pass reads.
enum class Part {
  brief,  ///< rocks, gates, barriers, trees, totals without envelopes and maps; the other tables, which are
          ///< long, are empty
  whole   ///< also inputs, impacts, trajectories, shapes, fixtures, series, envelopes, maps
};

using SeeRows = std::function<void(const TrialRecords& chunk)>;

/// Trials from `first` to before `end`.
struct TrialRange {
  std::uint64_t first = 0, end = std::numeric_limits<std::uint64_t>::max();

  bool meets(std::uint64_t from, std::uint64_t count) const { return from < end && from + count > first; }
};

/// Shows the chunks of a point in the order of their trials. A trial is never split, and every pass shows the
/// same rows. The chunk is destroyed when `see` returns. Throws FileError if a chunk cannot be read.
class Rows {
 public:
  /// Shows the chunks with trials of the range.
  using Read = std::function<void(Part part, const TrialRange& trials, const SeeRows& see)>;

  Rows(Read read) : read_(std::move(read)) {}
  void operator()(Part part, const SeeRows& see) const { read_(part, trials_, see); }
  /// Only the chunks with trials of the range; those of runs (Scenario::outer) end where a run does.
  Rows within(const TrialRange& trials) const {
    Rows rows = *this;
    rows.trials_ = trials;
    return rows;
  }

 private:
  Read read_;
  TrialRange trials_;
};

/// Rows that are already in memory, as one chunk. A range of trials cuts it.
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
