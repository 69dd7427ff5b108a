#pragma once
// Runs the chunks of a plan on several threads and reads the chunk files back in order.
//
// One thread runs a chunk from its first trial to its last. A trial depends only on its point and its number,
// so the chunk files are the same for any number of threads. They are processed in their order.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batch/chunk.h"
#include "record/records.h"
#include "sandbox/print_log.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Plan;

/// Appends one trial of one point to `out`, and returns what its Lua code printed, which is for the terminal
/// only.
using RunTrial = std::function<PrintLog(int point, std::uint64_t trial, TrialRecords& out)>;
/// Makes the function that runs the trials of a thread (numbered from 0). Called once in each thread.
using MakeWorker = std::function<RunTrial(int thread)>;

struct RunProgress {
  std::uint64_t done = 0, total = 0;  ///< trials
  std::uint64_t kept = 0;             ///< finished trials of an earlier run
  std::uint64_t rocks = 0;            ///< of this run
};

struct RunOptions {
  std::filesystem::path folder;  ///< of the chunk files; must exist
  std::string scenario_hash;
  int threads = 1;      ///< maximum; a thread runs at least one whole chunk
  bool resume = false;  ///< keep complete chunk files of this scenario that exist already
  const Plan* plan =
      nullptr;          ///< plan of kept chunks; without it, their records are not checked against a plan
  bool strict = false;  ///< end at the first rock that fails or the first step that does not converge
  std::function<bool()> interrupted = [] {
    return false;
  };  ///< asked before each trial, by any thread; a trial may also throw Interrupted
  std::function<void(const RunProgress&)> report = [](const RunProgress&) {
  };  ///< called after each trial, one call at a time
  /// Called with each chunk of the outcome, in order, while other chunks run: by any thread, one call at a
  /// time.
  std::function<void(int point, const TrialRecords&)> see = [](int, const TrialRecords&) {};
  /// Called with what Lua code printed, in the order of trials, at most PrintLog's limit of lines for each
  /// place. Chunks that are kept print nothing.
  std::function<void(const std::vector<std::string>& lines)> print = [](const std::vector<std::string>&) {};
};

enum class RunEnding {
  complete,
  interrupted,  ///< complete chunks are kept
  faults        ///< the first 20 rocks all failed, or `strict` met its first fault
};

struct RunOutcome {
  RunEnding ending = RunEnding::complete;
  std::string why;                 ///< for faults: what ended the run
  std::vector<ChunkRange> chunks;  ///< complete ones, in order; the last is short if a fault ended the run
  RunProgress progress;
  std::uint64_t failed = 0;     ///< rocks with faults
  PhaseTimes times;             ///< of the engine, summed over all trials of this run
  std::int64_t store_time = 0;  ///< ns, writing of chunk files, summed over all threads
  std::int64_t see_time = 0;    ///< ns, time in `see`
};

/// Runs `chunks` and leaves a file for each. The chunks of the outcome and their bytes are the same for any
/// number of threads, with or without kept chunks of an earlier run. Throws FileError if a file cannot be
/// written, and whatever `make_worker` throws.
RunOutcome run_chunks(const std::vector<ChunkRange>& chunks, const MakeWorker& make_worker,
                      const RunOptions& options);

}  // namespace flyrock
