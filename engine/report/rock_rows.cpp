#include "report/rock_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

namespace {

std::string table_of(const RockTable& table, int dimension) {
  std::vector<std::string> columns;
  for (const auto& [column, type] : table.columns)
    if (is_stored(column, dimension)) columns.push_back(fmt::format("{} {}", column.name, type));
  return fmt::format("CREATE TABLE {}_rows ({});\n", table.name, fmt::join(columns, ", "));
}

/// The + keeps SQLite from building an automatic index over all rows for a query. SQLite estimates this to be
/// cheaper than reading the few rows of a rock.
std::string view_of(const RockTable& table, int dimension) {
  std::string columns;
  for (const auto& [column, type] : table.columns)
    columns += is_stored(column, dimension) ? fmt::format(", +r.{0} AS {0}", column.name)
                                            : fmt::format(", 0.0 AS {}", column.name);
  return fmt::format(
      "CREATE VIEW {1} AS SELECT point, trial, rock{2} FROM rocks CROSS JOIN rows_of_rock AS own ON "
      "own.rowid = rocks.rowid "
      "CROSS JOIN {0}_rows AS r ON r.rowid BETWEEN own.first_{0} AND own.last_{0};\n",
      table.name, table.view, columns);
}

}  // namespace

const RockTable& input_table() {
  static const RockTable table{"input", "drawn",
                               columns_of<InputRecord>([](auto visit) { visit_inputs(visit); })};
  return table;
}

const RockTable& impact_table() {
  static const RockTable table{"impact", "impacts",
                               columns_of<ImpactRecord>([](auto visit) { visit_impacts(visit); })};
  return table;
}

const RockTable& trajectory_table() {
  static const RockTable table{"trajectory", "trajectories",
                               columns_of<TrajectoryRecord>([](auto visit) { visit_trajectories(visit); })};
  return table;
}

const RockTable& shape_table() {
  static const RockTable table{"shape", "shapes",
                               columns_of<ShapeRecord>([](auto visit) { visit_shapes(visit); })};
  return table;
}

int RockTable::width(int dimension) const {
  return static_cast<int>(std::count_if(columns.begin(), columns.end(), [&](const StoredColumn& stored) {
    return is_stored(stored.column, dimension);
  }));
}

std::string rock_tables_schema(int dimension) {
  std::string schema =
      "CREATE TABLE rows_of_rock (first_input INTEGER, last_input INTEGER, first_impact INTEGER, last_impact "
      "INTEGER, "
      "first_trajectory INTEGER, last_trajectory INTEGER, first_shape INTEGER, last_shape INTEGER);\n";
  for (const RockTable* table : {&input_table(), &impact_table(), &trajectory_table(), &shape_table()})
    schema += table_of(*table, dimension) + view_of(*table, dimension);
  return schema;
}

}  // namespace flyrock
