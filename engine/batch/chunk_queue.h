#pragma once
// Gives the chunks of a run to its threads and decides where the run ends. The end does not depend on which
// thread is faster.
//
// A fault that ends a run has a place in the order of chunks and trials. Chunks are handed out in order, so
// all chunks before it are finished or in progress. The queue waits for them, and an earlier end among them
// wins. Later chunks are no longer wanted.

#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <string>

#include "record/records.h"

namespace flyrock {

class ChunkQueue {
 public:
  /// `strict`: a rock that fails or a step that did not converge ends the run.
  ChunkQueue(std::size_t chunks, bool strict) : chunks_(chunks), strict_(strict) {}

  /// The index of the next chunk; nothing if there is none left. As long as every rock has failed, only one
  /// chunk is handed out at a time and the other threads wait, so that "the first 20 rocks all failed" is
  /// judged in order.
  std::optional<std::size_t> take();

  /// Judges a trial of a chunk. Its rocks start at `from` in the records of the chunk. False if the trial
  /// ends the run.
  bool judge(std::size_t chunk, const TrialRecords& records, std::size_t from);

  /// Whether a fault in a chunk that is taken now could end the run.
  bool may_end() const;
  /// Whether a chunk lies before the end of the run, as far as the end is known.
  bool wanted(std::size_t chunk) const;
  /// Says that the chunk is finished or given up.
  void finish();
  /// Hands out no more chunks; no chunk is wanted any more.
  void stop();

  /// The chunk in which a fault ended the run, and why. Without such a fault, the number of chunks and an
  /// empty text.
  std::size_t end() const;
  const std::string& why() const { return why_; }  ///< call it after all threads have ended

 private:
  std::string reason(const TrialRecords& records, std::size_t from);

  const std::size_t chunks_;
  const bool strict_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;
  int under_way_ = 0;
  std::uint64_t failed_ = 0;  ///< rocks, up to the first that did not fail
  bool hope_ = false;         ///< a rock did not fail
  bool stopped_ = false;
  std::size_t end_ = std::numeric_limits<std::size_t>::max();
  std::string why_;
};

}  // namespace flyrock
