#pragma once
// results.db: everything that a run left, as tables of SQLite. docs/results.md describes the schema.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "report/sqlite.h"
#include "results/results.h"

namespace flyrock {

class ResultDatabase {
 public:
  /// Opens the file under a temporary name and makes its tables. Throws FileError, as all that follows.
  ResultDatabase(const std::filesystem::path& path, const Plan& plan);

  /// The rows of a chunk of one point; chunks come in order.
  void add(int point, const TrialRecords& records);

  /// Behind the last chunk: the indices of its rows. They take a while, and other work can be done beside
  /// them.
  void index();

  /// Points, terrain parts and expectations, and `report`, the data of the page. The file gets its name.
  void finish(const Results& results, const std::string& report);

 private:
  struct Insertions {
    Insertions(const SqliteFile& file, int dimension);
    Insertion rocks, rows_of_rock, inputs, impacts, trajectories, gates, barriers;
  };

  void add_plan();

  const Plan& plan_;
  std::vector<std::string> groups_;
  SqliteFile file_;
  std::unique_ptr<Insertions> insertions_;
  struct {
    std::int64_t inputs = 0, impacts = 0, trajectories = 0;
  } written_;  ///< rows
};

/// What finish() was given as `report`. Throws UnreadableFile.
std::string stored_report(const std::filesystem::path& path);

}  // namespace flyrock
