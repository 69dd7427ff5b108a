#include "report/tables/record_tables.h"

#include <fmt/format.h>

#include "files/sha256.h"
#include "record/columns.h"

namespace flyrock {

namespace {

/// The declarations of columns: `"mass_kg" REAL`. `visit` visits the columns of Row.
template <class Row>
auto declare_into(std::vector<std::string>& columns, const Table& table, const TableContent& content) {
  return [&columns, table, content](const Column& column, auto get) {
    using T = std::decay_t<std::invoke_result_t<decltype(get), const Row&>>;
    if (is_stored(table, column, content))
      columns.push_back(fmt::format("\"{}\" {}", column.name, sql_type<T>(column)));
  };
}

/// The + keeps SQLite from building an automatic index over all rows for a query. SQLite estimates this to be
/// cheaper than reading the few rows of a rock.
template <class VisitColumns>
std::string view_of(const Table& table, VisitColumns visit_columns, const TableContent& content) {
  std::string columns;
  visit_columns([&](const Column& column, auto) {
    if (column.name)
      columns += is_stored(table, column, content) ? fmt::format(", +r.{0} AS {0}", column.name)
                                                   : fmt::format(", 0.0 AS {}", column.name);
  });
  return fmt::format(
      "CREATE VIEW {1} AS SELECT point, trial, rock{2} FROM rocks CROSS JOIN rows_of_rock AS own ON "
      "own.rowid = rocks.rowid "
      "CROSS JOIN {0}_rows AS r ON r.rowid BETWEEN own.first_{0} AND own.last_{0};\n",
      table.many_rows, table.name, columns);
}

template <class T>
void write_value(ColumnWriter& bytes, const T& value) {
  if constexpr (std::is_same_v<T, std::string_view>)
    bytes.value(std::string(value));
  else
    bytes.value(value);
}

}  // namespace

std::string stored_name(const Table& table) {
  return table.many_rows ? fmt::format("{}_rows", table.many_rows) : table.name;
}

std::string record_tables_schema(const TableContent& content) {
  std::string tables, views;
  std::vector<std::string> ranges;
  visit_tables(none_of_the_records, [&](const Table& table, const auto& rows, auto visit_columns) {
    using Row = typename std::decay_t<decltype(rows)>::value_type;
    std::vector<std::string> columns;
    const auto declare = declare_into<Row>(columns, table, content);
    if (!table.many_rows) {
      columns.push_back("point INTEGER");
      visit_owner<Row>(table, declare);
    } else {
      ranges.push_back(fmt::format("first_{0} INTEGER, last_{0} INTEGER", table.many_rows));
      views += view_of(table, visit_columns, content);
    }
    visit_columns(declare);
    tables += fmt::format("CREATE TABLE {} ({});\n", stored_name(table), fmt::join(columns, ", "));
  });
  return tables + fmt::format("CREATE TABLE rows_of_rock ({});\n", fmt::join(ranges, ", ")) + views;
}

std::int64_t RowsOfRocks::first_of(std::size_t table, const std::string& bytes, std::int64_t count) {
  std::int64_t& written = written_[table];
  const std::int64_t next = written + 1;
  if (share_ && count > 0) {
    // Half of a SHA-256 tells any rows apart that a run can have.
    constexpr std::size_t digits = 32;
    const std::string digest = sha256(bytes).substr(0, digits);
    if (const auto found = remembered_.find(digest); found != remembered_.end()) return found->second;
    if (remembered_.size() < most_remembered) remembered_.emplace(digest, next);
  }
  written += count;
  return next;
}

std::vector<RowsOfRocks::OfTable> RowsOfRocks::of(const TrialRecords& records, const RecordNames& names,
                                                  const TableContent& content) {
  written_.resize(static_cast<std::size_t>(tables()));
  std::vector<OfTable> list;
  visit_tables(records, [&](const Table& table, const auto& rows, auto visit_columns) {
    if constexpr (requires { rows[0].rock; }) {
      if (!table.many_rows) return;
      const std::size_t number = list.size();
      OfTable& of_table = list.emplace_back();
      const auto write_into = [&](ColumnWriter& bytes, const auto& row) {
        visit_columns([&](const Column& column, auto get) {
          if (is_stored(table, column, content))
            shown_value(column, member_of(row, get), names,
                        [&](const auto& value) { write_value(bytes, value); });
        });
      };
      std::size_t row = 0;
      for (const RockRecord& rock : records.rocks) {
        const std::size_t begin = row;
        ColumnWriter bytes;
        bytes.value(number);
        for (; row < rows.size() && rows[row].trial == rock.trial && rows[row].rock == rock.rock; ++row)
          if (share_) write_into(bytes, rows[row]);
        const auto count = static_cast<std::int64_t>(row - begin);
        const std::int64_t next = written_[number] + 1, first = first_of(number, bytes.bytes(), count);
        of_table.of_rock.push_back({first, first + count - 1});
        if (first == next)
          for (std::size_t i = begin; i < row; ++i) of_table.to_write.push_back(i);
      }
    }
  });
  return list;
}

int RowsOfRocks::tables() {
  int count = 0;
  visit_tables(none_of_the_records,
               [&](const Table& table, const auto&, auto) { count += table.many_rows != nullptr; });
  return count;
}

}  // namespace flyrock
