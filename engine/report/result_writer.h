#pragma once
// Writes the files of a result from its chunks: rocks.csv, last_states.csv, results.db, summary.json and
// report.html.

#include <filesystem>
#include <vector>

#include "files/safe_file.h"
#include "load/load.h"
#include "report/page/report_data.h"
#include "report/tables/database.h"
#include "results/results.h"

namespace flyrock {

struct Plan;

/// Takes the chunks in a first pass, which may take place during the run, so that little work remains after
/// the last trial. Files have temporary names until finish() has written all their contents; without finish()
/// they are removed.
class ResultWriter {
 public:
  /// This and all other functions throw FileError.
  ResultWriter(const std::filesystem::path& folder, const LoadedScenario& scenario);

  /// Takes the chunks of all points in order, with all their rows.
  void add(int point, const TrialRecords& chunk);

  /// Reads the same chunks again in passes. `terrains`: for pictures, one for each point. `assets`: see
  /// report_html().
  Results finish(const std::vector<Rows>& rows, const RunFacts& facts, std::vector<TerrainPicture> terrains,
                 const std::filesystem::path& assets);

 private:
  /// Heads of tables, which the first chunk decides: a population may answer weights that the scenario does
  /// not have.
  void begin(const TrialRecords& first);
  /// Where `output.rocks` is false: the rows of the rocks of a chunk that are among the first of their point.
  TrialRecords first_rows(int point, const TrialRecords& chunk);

  std::filesystem::path folder_;
  bool begun_ = false;
  bool weighted_ = false;  ///< the rocks have weights
  const Plan& plan_;
  FileWriter csv_, last_states_;
  ResultDatabase database_;
  ResultTally tally_;
  ReportData report_;
  std::vector<std::size_t> rows_left_;  ///< of each point: rocks that still get rows
};

}  // namespace flyrock
