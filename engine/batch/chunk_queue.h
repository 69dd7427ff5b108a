#pragma once
// Hands the chunks of a run to its threads and decides where the run ends, so that the end does not depend on
// which thread was faster.
//
// A fault that ends a run does so at its place in the order of chunks and trials. Chunks are handed out in
// order, so all chunks before it are finished or under way: they are waited for, and an earlier end among
// them wins. Chunks behind it are no longer wanted.

#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <string>

#include "batch/records.h"

namespace flyrock {

class ChunkQueue {
 public:
  /// `strict`: a rock that fails or a step that did not converge ends the run.
  ChunkQueue(std::size_t chunks, bool strict) : chunks_(chunks), strict_(strict) {}

  /// The index of the next chunk, or nothing where there is none left. So long as every rock failed, one
  /// chunk is handed out at a time and the others wait: whether the first 20 all fail is then judged in
  /// order.
  std::optional<std::size_t> take();

  /// Judges a trial of a chunk, whose rocks start at `from` in the records of the chunk. False where it ends
  /// the run.
  bool judge(std::size_t chunk, const TrialRecords& records, std::size_t from);

  /// Whether a fault could end the run in a chunk that is taken now.
  bool may_end() const;
  /// Whether a chunk lies before the end, as far as that is known.
  bool wanted(std::size_t chunk) const;
  /// The chunk is done or given up.
  void finish();
  /// Hands out nothing more; no chunk is wanted any more.
  void stop();

  /// The chunk in which a fault ended the run, and why; the number of chunks and an empty text where none
  /// did.
  std::size_t end() const;
  const std::string& why() const { return why_; }  ///< asked when all threads have ended

 private:
  std::string reason(const TrialRecords& records, std::size_t from);

  const std::size_t chunks_;
  const bool strict_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;
  int under_way_ = 0;
  std::uint64_t failed_ = 0;  ///< rocks, until the first that did not
  bool hope_ = false;         ///< a rock came through
  bool stopped_ = false;
  std::size_t end_ = std::numeric_limits<std::size_t>::max();
  std::string why_;
};

}  // namespace flyrock
