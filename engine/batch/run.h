#pragma once
// Runs the chunks of a plan, and puts the chunk files together again.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batch/chunk.h"
#include "batch/records.h"

namespace flyrock {

/// Appends one trial of one point to `out`.
using RunTrial = std::function<void(int point, std::uint64_t trial, TrialRecords& out)>;

struct RunProgress {
  std::uint64_t done = 0, total = 0;  ///< trials
  std::uint64_t rocks = 0;
};

struct RunOptions {
  std::filesystem::path folder;   ///< of the chunk files; it exists
  std::string scenario_hash;
  bool strict = false;            ///< end at the first rock that fails, at the first step that did not converge
  std::function<bool()> interrupted = [] { return false; };          ///< asked before each trial
  std::function<void(const RunProgress&)> report = [](const RunProgress&) {};  ///< told after each trial
};

enum class RunEnding {
  complete,
  interrupted,  ///< the chunks that were whole are kept
  faults        ///< the first 20 rocks all failed, or `strict` met its first fault
};

struct RunOutcome {
  RunEnding ending = RunEnding::complete;
  std::string why;                 ///< faults: what ended the run
  std::vector<ChunkRange> chunks;  ///< written, in order; the last is short where a fault ended the run
  RunProgress progress;
  PhaseTimes times;                ///< of the engine, all trials together
};

/// Runs `chunks` in order and writes a file for each. Throws FileError where one cannot be written.
RunOutcome run_chunks(const std::vector<ChunkRange>& chunks, const RunTrial& run_trial, const RunOptions& options);

/// The records of each point, from the chunk files in order. Throws FileError where one is not what was written.
std::vector<TrialRecords> merge_chunks(const std::vector<ChunkRange>& chunks, int points,
                                       const std::filesystem::path& folder, const std::string& scenario_hash);

/// Removes chunk files, and their folder where nothing else is in it. Throws FileError.
void remove_chunks(const std::vector<ChunkRange>& chunks, const std::filesystem::path& folder);

}  // namespace flyrock
