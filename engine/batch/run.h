#pragma once
// Runs the chunks of a plan on several threads, and puts the chunk files together again.
//
// A chunk is run by one thread from its first trial to its last, and a trial depends on nothing but its point
// and number: the chunk files are the same for any number of threads. What is done with them is done in their
// order.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batch/chunk.h"
#include "batch/records.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Appends one trial of one point to `out`.
using RunTrial = std::function<void(int point, std::uint64_t trial, TrialRecords& out)>;
/// Makes what runs the trials of a thread, counted from 0; called once in each thread.
using MakeWorker = std::function<RunTrial(int thread)>;

struct RunProgress {
  std::uint64_t done = 0, total = 0;  ///< trials
  std::uint64_t kept = 0;             ///< of those done: by an earlier run
  std::uint64_t rocks = 0;            ///< of this run
};

struct RunOptions {
  std::filesystem::path folder;  ///< of the chunk files; it exists
  std::string scenario_hash;
  int threads = 1;             ///< at most; a chunk is the least that a thread is given
  bool resume = false;         ///< keep whole chunk files of this scenario that are there
  const Plan* plan = nullptr;  ///< whose chunks are kept; without it, what is in them is not held against it
  bool strict = false;         ///< end at the first rock that fails, at the first step that did not converge
  std::function<bool()> interrupted = [] {
    return false;
  };  ///< asked before each trial, by any thread; a trial may throw Interrupted besides
  std::function<void(const RunProgress&)> report = [](const RunProgress&) {
  };  ///< told after each trial, one at a time
  /// Shown each chunk of the outcome in its order, while others run: by any thread, one at a time.
  std::function<void(int point, const TrialRecords&)> see = [](int, const TrialRecords&) {};
  /// Told what Lua code printed, in the order of trials, PrintLog's lines of a place at most. Chunks that are
  /// kept print nothing.
  std::function<void(const std::vector<std::string>& lines)> print = [](const std::vector<std::string>&) {};
};

enum class RunEnding {
  complete,
  interrupted,  ///< the chunks that were whole are kept
  faults        ///< the first 20 rocks all failed, or `strict` met its first fault
};

struct RunOutcome {
  RunEnding ending = RunEnding::complete;
  std::string why;                 ///< faults: what ended the run
  std::vector<ChunkRange> chunks;  ///< whole ones, in order; the last is short where a fault ended the run
  RunProgress progress;
  std::uint64_t failed = 0;     ///< rocks with faults
  PhaseTimes times;             ///< of the engine, all trials of this run together
  std::int64_t store_time = 0;  ///< ns for writing chunk files, all threads together
  std::int64_t see_time = 0;    ///< ns for showing chunks
};

/// Runs `chunks` and leaves a file for each. The chunks of the outcome, and their bytes, are the same for any
/// number of threads, and whether chunks of an earlier run were kept or not. Throws FileError where one
/// cannot be written, and what `make_worker` throws.
RunOutcome run_chunks(const std::vector<ChunkRange>& chunks, const MakeWorker& make_worker,
                      const RunOptions& options);

}  // namespace flyrock
