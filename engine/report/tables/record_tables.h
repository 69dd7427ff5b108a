#pragma once
// The tables of record/tables.h in results.db.
//
// A table in which a rock has many rows is stored as <row>_rows, without the columns of its owner. The rows
// of a rock are consecutive there, and rows_of_rock holds the first and the last of each rock, in the order
// of `rocks`: an index by point, trial and rock would take as long to build as the rows take to write. A view
// shows the rows with their rock.
//
// All points of a sweep have the same random numbers, so that a rock often has the same rows at several
// points: where only a barrier is swept, up to that barrier's place. Equal rows are stored once, and the
// rocks share their range.

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "record/tables.h"
#include "report/tables/shown_value.h"

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

  /// The rows of one table in a chunk.
  struct OfTable {
    std::vector<Range> of_rock;
    std::vector<std::size_t> to_write;  ///< numbers of the rows in the chunk that are not stored yet
  };

  /// `share`: rocks with equal rows share them.
  explicit RowsOfRocks(bool share) : share_(share) {}

  /// The tables of the next chunk, in the order of visit_tables. Rows are equal if tables show the same.
  std::vector<OfTable> of(const TrialRecords& records, const RecordNames& names, const TableContent& content);
  static int tables();

 private:
  /// Further rows are stored although they may be stored already: what is remembered takes 25 MB at most.
  static constexpr std::size_t most_remembered = 200'000;

  /// The first row of `count` rows with these bytes; the next row to be written where they are new.
  std::int64_t first_of(std::size_t table, const std::string& bytes, std::int64_t count);

  bool share_;
  std::vector<std::int64_t> written_;                         ///< rows of earlier chunks in each table
  std::unordered_map<std::string, std::int64_t> remembered_;  ///< the first row by the digest of all
};

}  // namespace flyrock
