#pragma once
// A sensitivity analysis: its runs as the points of one run, and what their chunks say together.

#include <filesystem>
#include <string>
#include <vector>

#include "batch/chunk_files.h"
#include "batch/exchanged_inputs.h"
#include "batch/run.h"
#include "cli/request.h"
#include "load/load.h"
#include "results/statistics/explained_variance.h"

namespace flyrock::cli {

/// The two bases are the points 0 and 1 of a run; input i is the point i + 2, the first base with this input
/// from the second. All have the same scenario and the same trials, so chunks, shards and --resume are those
/// of a run.
struct Analysis {
  ExchangedInputs inputs;
  std::vector<Exchange> tables;       ///< of each point
  std::vector<TrialMeasure> numbers;  ///< what is explained; point into the scenario
  std::optional<double> line;         ///< SI, of the first number
  std::vector<ChunkRange> chunks;
  std::uint64_t trials = 0;  ///< of each point
};

/// Reads what the words ask of a scenario, and makes the scenario's hash that of the analysis. Throws
/// InputError for what a scenario cannot be asked, UsageError for a word.
Analysis make_analysis(LoadedScenario& scenario, const AnalysisRequest& words);

/// Throws InputError if a p95 is asked of fewer than 20 rocks, by the first trial.
void refuse_few_rocks(const LoadedScenario& scenario, const Analysis& analysis);

/// The workers of its runs. Thread 0 uses `scenario`, every other one reads it again from `request`.
MakeWorker analysis_workers(LoadedScenario& scenario, const Analysis& analysis, const Request& request);

/// Reads the chunks of all points and explains each number.
ExplainedVariance explain(const LoadedScenario& scenario, const Analysis& analysis,
                          std::vector<ChunkFile> files);

/// faults where a number is not known because rocks were lost, else done.
int exit_code(const ExplainedVariance& found);

/// Trials that are tried out before an analysis starts.
inline constexpr std::uint64_t tried_of_analysis = 200;

/// Writes sensitivity.json and sensitivity.html, and prints the answer unless `quiet`.
void write_analysis(const ExplainedVariance& found, const std::filesystem::path& folder, bool quiet);

inline constexpr const char* analysis_file = "sensitivity.json";
inline constexpr const char* analysis_page = "sensitivity.html";

}  // namespace flyrock::cli
