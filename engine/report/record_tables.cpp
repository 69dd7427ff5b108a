#include "report/record_tables.h"

#include <fmt/format.h>

#include "report/shown_value.h"

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

std::vector<std::vector<RowsOfRocks::Range>> RowsOfRocks::of(const TrialRecords& records) {
  written_.resize(static_cast<std::size_t>(tables()));
  std::vector<std::vector<Range>> ranges;
  visit_tables(records, [&](const Table& table, const auto& rows, auto) {
    if constexpr (requires { rows[0].rock; }) {
      if (!table.many_rows) return;
      std::int64_t& written = written_[ranges.size()];
      std::vector<Range>& of_table = ranges.emplace_back();
      auto row = rows.begin();
      for (const RockRecord& rock : records.rocks) {
        const std::int64_t first = written + 1;
        for (; row != rows.end() && row->trial == rock.trial && row->rock == rock.rock; ++row) ++written;
        of_table.push_back({first, written});
      }
    }
  });
  return ranges;
}

int RowsOfRocks::tables() {
  int count = 0;
  visit_tables(none_of_the_records,
               [&](const Table& table, const auto&, auto) { count += table.many_rows != nullptr; });
  return count;
}

}  // namespace flyrock
