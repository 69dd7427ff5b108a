#pragma once
// The tables of record/tables.h in results.db.
//
// A table in which a rock has many rows is stored as <row>_rows, without the columns of its owner. The rows
// of a rock are consecutive there, and rows_of_rock holds the first and the last of each rock, in the order
// of `rocks`: an index by point, trial and rock would take as long to build as the rows take to write. A view
// shows the rows with their rock.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "record/tables.h"

namespace flyrock {

/// Whether results.db stores a column. Columns of the third dimension are left out of long tables in 2D.
inline bool is_stored(const Table& table, const Column& column, const TableContent& content) {
  return column.name && column.is_of(content) &&
         (!table.many_rows || !column.in_space || content.dimension == 3);
}

/// The name of the table that stores the rows: "gates", "impact_rows".
std::string stored_name(const Table& table);

/// CREATE TABLE and CREATE VIEW of all tables, and of rows_of_rock.
std::string record_tables_schema(const TableContent& content);

/// Number of columns of the stored table.
template <class Row, class VisitColumns>
int stored_width(const Table& table, VisitColumns visit_columns, const TableContent& content) {
  int width = table.many_rows ? 0 : 1;  // point
  const auto count = [&](const Column& column, auto) { width += is_stored(table, column, content); };
  if (!table.many_rows) visit_owner<Row>(table, count);
  visit_columns(count);
  return width;
}

/// The first and the last row of each rock in the tables with many rows, counted from 1 over all chunks. A
/// rock without rows has its last before its first.
class RowsOfRocks {
 public:
  using Range = std::pair<std::int64_t, std::int64_t>;

  /// The ranges of the next chunk: by table, then by rock.
  std::vector<std::vector<Range>> of(const TrialRecords& records);
  static int tables();

 private:
  std::vector<std::int64_t> written_;  ///< rows of earlier chunks in each table
};

}  // namespace flyrock
