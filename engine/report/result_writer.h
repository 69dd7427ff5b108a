#pragma once
// The files of a result, built from its chunks: rocks.csv, results.db, summary.json and report.html.

#include <filesystem>
#include <vector>

#include "batch/load.h"
#include "batch/safe_file.h"
#include "report/database.h"
#include "report/report_data.h"
#include "results/results.h"

namespace flyrock {

/// Takes the chunks in a first pass, which may be while the run goes on, so that little is left to do behind
/// its last trial. Files have temporary names until finish() has all that goes into them; without it they go
/// away.
class ResultWriter {
 public:
  /// Throws FileError, as all that follows.
  ResultWriter(const std::filesystem::path& folder, const LoadedScenario& scenario);

  /// The chunks of all points in order, with all their rows.
  void see(int point, const TrialRecords& chunk);

  /// Reads the same chunks again in passes. `terrains` are those of the pictures, of each point; `assets` see
  /// report_html().
  Results finish(const std::vector<Rows>& rows, const RunFacts& facts, std::vector<Profile> terrains,
                 const std::filesystem::path& assets);

 private:
  std::filesystem::path folder_;
  const Plan& plan_;
  FileWriter csv_;
  ResultDatabase database_;
  ResultTally tally_;
  ReportData report_;
};

}  // namespace flyrock
