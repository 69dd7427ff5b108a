#pragma once
// The tables of a result folder as text. The same results give the same bytes on every machine and run;
// only run.log holds what may differ. docs/results.md describes every column and key.

#include <string>
#include <vector>

#include "batch/load.h"
#include "results/results.h"

namespace flyrock {

/// Of the layout of a result folder and its database: raised when an older flyrock, or this one with an older
/// folder, would misread it.
inline constexpr int result_format = 6;

/// A row per rock in order of point, trial and rock; numbers as the shortest decimals that read back as
/// the same double, nothing where there is no number; censored as 0 or 1.
std::string rocks_csv_header(const Plan& plan);
std::string rocks_csv_rows(const Plan& plan, int point, const std::vector<RockRecord>& rocks);

/// Statistics of each point, expectations, solver quality, warnings. Holds no path, file name or hash.
std::string summary_json(const Plan& plan, const Results& results);

/// What was run: the resolved scenario, the engine's version, the hashes of all plugin sources and of the
/// files that parameters name, chunk size.
std::string manifest_json(const LoadedScenario& scenario);

/// Where and when a run was, and where its time went.
struct RunLog {
  std::string started;  ///< local time, ISO 8601
  std::string host;
  int threads = 1;
  double seconds = 0;  ///< of wall time, from the first trial to the last, with its chunk files
  std::uint64_t rocks = 0, trials = 0;  ///< of this run
  std::uint64_t kept = 0;               ///< trials of earlier runs that it went on from, or of shards
  PhaseTimes times;
  double store_seconds = 0;   ///< of wall time, for the chunk files: those of all threads over their number
  long peak_memory = 0;       ///< kB, of the process
  double table_seconds = 0;   ///< the same, for the tables that grow while trials run
  double finish_seconds = 0;  ///< of wall time, behind the last trial: the rest of the tables, and the report
};
std::string run_log(const RunLog& log);

}  // namespace flyrock
