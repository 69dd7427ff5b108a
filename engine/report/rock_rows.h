#pragma once
// Tables of results.db in which a rock has many rows.
//
// The rows of a rock follow each other in a table, and rows_of_rock has the first and the last of each rock,
// in the order of `rocks`: an index by point, trial and rock would take as long to build as the rows to
// write. A view shows the rows with their rock.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "batch/record_columns.h"

namespace flyrock {

/// A table <name>_rows and its view.
struct RockTable {
  struct StoredColumn {
    Column column;
    const char* type;  ///< of SQL
  };
  const char* name;  ///< "input", "impact", "trajectory"
  const char* view;
  std::vector<StoredColumn> columns;

  /// How many are stored.
  int width(int dimension) const;
};

/// A column of the tables in which a rock has many rows: those of the third dimension are not stored in 2D.
inline bool is_stored(const Column& column, int dimension) {
  return column.name && (!column.in_space || dimension == 3);
}

const RockTable& input_table();
const RockTable& impact_table();
const RockTable& trajectory_table();

/// CREATE TABLE and VIEW of the three, and of rows_of_rock.
std::string rock_tables_schema(int dimension);

/// Which rows of a table are whose: they come in the order of the rocks.
template <class Row>
class RowsOfRocks {
 public:
  /// `written`: rows of earlier chunks; it is counted on.
  RowsOfRocks(const std::vector<Row>& rows, std::int64_t& written) : rows_(rows), written_(written) {}

  /// First and last of the next rock, from 1; the last is before the first where it has none.
  std::pair<std::int64_t, std::int64_t> of(const RockRecord& rock) {
    const std::int64_t first = written_ + 1;
    for (; at_ < rows_.size() && rows_[at_].trial == rock.trial && rows_[at_].rock == rock.rock; ++at_)
      ++written_;
    return {first, written_};
  }

 private:
  const std::vector<Row>& rows_;
  std::size_t at_ = 0;
  std::int64_t& written_;
};

}  // namespace flyrock
