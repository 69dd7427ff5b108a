#pragma once
// The tables of a result folder as text. The same results give the same bytes on every machine and in every
// run. Only run.log may differ. docs/results.md describes every column and key.

#include <string>
#include <vector>

#include "load/load.h"
#include "results/results.h"

namespace flyrock {

struct Plan;

/// The version of the layout of a result folder and its database. It is raised if an older flyrock would
/// misread a new folder, or this flyrock an older folder.
inline constexpr int result_format = 18;

/// One row for each rock, in the order of point, trial and rock. Numbers are the shortest decimals that read
/// back as the same double; a missing number is an empty field; censored is 0 or 1. `weighted`: the rocks
/// have weights.
std::string rocks_csv_header(const Plan& plan, bool weighted = false);
std::string rocks_csv_rows(const Plan& plan, int point, const std::vector<RockRecord>& rocks,
                           bool weighted = false);

/// The last state of each body that moves: last_states.csv, in the same form.
std::string last_states_csv_header(const Plan& plan);
std::string last_states_csv_rows(const Plan& plan, int point, const std::vector<LastStateRecord>& states);

/// Statistics of each point, expectations, solver quality, warnings. Holds no path, file name or hash.
std::string summary_json(const Plan& plan, const Results& results);

/// The inputs of a run: the resolved scenario, the arguments of its Lua files, the engine's version, the
/// hashes of all plugin sources and of the files that parameters name, and the chunk size.
std::string manifest_json(const LoadedScenario& scenario);

/// Where and when a run took place, and how its time was spent.
struct RunLog {
  std::string started;  ///< local time, ISO 8601
  std::string host;
  int threads = 1;
  double seconds = 0;                   ///< wall time from the first trial to the last, including chunk files
  std::uint64_t rocks = 0, trials = 0;  ///< of this run
  std::uint64_t kept = 0;               ///< trials taken from earlier runs or from shards
  PhaseTimes times;
  double store_seconds =
      0;  ///< wall time of writing chunk files: the sum over all threads divided by their number
  long peak_memory = 0;       ///< kB, of the process
  double table_seconds = 0;   ///< the same for the tables that are written during the trials
  double finish_seconds = 0;  ///< wall time after the last trial: the other tables and the report
};
std::string run_log(const RunLog& log);

}  // namespace flyrock
