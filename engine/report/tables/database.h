#pragma once
// results.db: all results of a run as SQLite tables. docs/results.md describes the schema.

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "report/pictures/ground_pictures.h"
#include "report/tables/record_tables.h"
#include "report/tables/shown_value.h"
#include "report/tables/sqlite.h"
#include "results/results.h"

namespace flyrock {

struct Plan;

class ResultDatabase {
 public:
  /// Opens the file under a temporary name. This and all other functions throw FileError.
  ResultDatabase(const std::filesystem::path& path, const Plan& plan);

  /// Makes its tables, before all others. `weighted`: rocks have weights.
  void begin(bool weighted);

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
    Insertions(const SqliteFile& file, const TableContent& content);
    std::deque<Insertion> tables;  ///< in the order of visit_tables
    Insertion rows_of_rock;
  };

  void add_plan();
  void add_input_paths();

  const Plan& plan_;
  std::vector<RecordNames> names_;  ///< of each point
  TableContent content_;
  SqliteFile file_;
  std::unique_ptr<Insertions> insertions_;
  RowsOfRocks rows_of_rocks_;
};

/// The `report` that was given to finish(). Throws UnreadableFile.
std::string stored_report(const std::filesystem::path& path);

}  // namespace flyrock
