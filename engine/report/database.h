#pragma once
// results.db: all results of a run as SQLite tables. docs/results.md describes the schema.

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "report/ground_pictures.h"
#include "report/sqlite.h"
#include "results/results.h"

namespace flyrock {

class ResultDatabase {
 public:
  /// Opens the file under a temporary name and makes its tables. This and all other functions throw
  /// FileError.
  ResultDatabase(const std::filesystem::path& path, const Plan& plan);

  /// Adds the rows of a chunk of one point. Chunks must come in order.
  void add(int point, const TrialRecords& records);

  /// Builds the indices of the rows, after the last chunk. It takes a while; other work can run at the same
  /// time.
  void index();

  /// Writes points, terrain parts and grounds, expectations, and `report`, the data of the page. Then renames
  /// the file to its final name.
  void finish(const Results& results, const GroundPictures& grounds, const std::string& report);

 private:
  struct Insertions {
    Insertions(const SqliteFile& file, int dimension);
    Insertion rocks, rows_of_rock, inputs, impacts, trajectories, shapes, gates, barriers, trees;
    std::deque<Insertion> of_trials;  ///< in the order of visit_trial_tables
  };

  void add_plan();
  void add_input_paths();

  const Plan& plan_;
  std::vector<std::string> groups_;
  std::vector<std::vector<int>> input_ids_;  ///< of each point and input, in the table `input_paths`
  SqliteFile file_;
  std::unique_ptr<Insertions> insertions_;
  struct {
    std::int64_t inputs = 0, impacts = 0, trajectories = 0, shapes = 0;
  } written_;  ///< rows
};

/// The `report` that was given to finish(). Throws UnreadableFile.
std::string stored_report(const std::filesystem::path& path);

}  // namespace flyrock
