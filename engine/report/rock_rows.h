#pragma once
// The tables of results.db in which a rock has many rows.
//
// The rows of a rock are consecutive in a table, and rows_of_rock holds the first and the last row of each
// rock, in the order of `rocks`. An index by point, trial and rock would take as long to build as the rows
// take to write. A view shows the rows with their rock.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "batch/record_columns.h"

namespace flyrock {

/// A column of results.db.
struct StoredColumn {
  Column column;
  const char* type;  ///< of SQL
};

/// The columns of a table that have a name, from its visit.
template <class Row, class VisitTable>
std::vector<StoredColumn> columns_of(VisitTable visit_table) {
  std::vector<StoredColumn> columns;
  visit_table([&](const Column& column, auto get) {
    using T = std::decay_t<std::invoke_result_t<decltype(get), const Row&>>;
    if (column.name) columns.push_back({column, sql_type<T>(column)});
  });
  return columns;
}

/// A table <name>_rows and its view.
struct RockTable {
  const char* name;  ///< "input", "impact", "trajectory", "shape"
  const char* view;
  std::vector<StoredColumn> columns;

  /// The number of stored columns.
  int width(int dimension) const;
};

/// Whether a column is stored in these tables. Columns of the third dimension are not stored in 2D.
inline bool is_stored(const Column& column, int dimension) {
  return column.name && (!column.in_space || dimension == 3);
}

const RockTable& input_table();
const RockTable& impact_table();
const RockTable& trajectory_table();
const RockTable& shape_table();

/// CREATE TABLE and CREATE VIEW of the four tables, and of rows_of_rock.
std::string rock_tables_schema(int dimension);

/// Finds the rows of each rock. They must come in the order of the rocks.
template <class Row>
class RowsOfRocks {
 public:
  /// `written`: number of rows of earlier chunks; continues to count here.
  RowsOfRocks(const std::vector<Row>& rows, std::int64_t& written) : rows_(rows), written_(written) {}

  /// First and last row of the next rock, from 1. If it has no rows, the last is before the first.
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
