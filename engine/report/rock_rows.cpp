#include "report/rock_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

const RockTable input_table = {"input", "drawn", {{"draw", "INTEGER"}, {"value", "REAL"}}};

const RockTable impact_table = {"impact",
                                "impacts",
                                {{"number", "INTEGER"},
                                 {"time_s", "REAL"},
                                 {"x_m", "REAL"},
                                 {"y_m", "REAL"},
                                 {"z_m", "REAL", true},
                                 {"other", "INTEGER"},
                                 {"part", "INTEGER"},
                                 {"vn_before_m_s", "REAL"},
                                 {"vn_after_m_s", "REAL"},
                                 {"vt_before_m_s", "REAL"},
                                 {"vt_after_m_s", "REAL"},
                                 {"pn_N_s", "REAL"},
                                 {"pt_N_s", "REAL"},
                                 {"energy_change_J", "REAL"}}};

const RockTable trajectory_table = {"trajectory",
                                    "trajectories",
                                    {{"time_s", "REAL"},
                                     {"x_m", "REAL"},
                                     {"y_m", "REAL"},
                                     {"z_m", "REAL", true},
                                     {"vx_m_s", "REAL"},
                                     {"vy_m_s", "REAL"},
                                     {"vz_m_s", "REAL", true},
                                     {"spin_x_rad_s", "REAL", true},
                                     {"spin_y_rad_s", "REAL", true},
                                     {"spin_z_rad_s", "REAL"},
                                     {"angle_rad", "REAL"},
                                     {"kinetic_energy_J", "REAL"},
                                     {"mode", "TEXT"}}};

namespace {

std::string table_of(const RockTable& table, int dimension) {
  std::vector<std::string> columns;
  for (const RockTable::Column& c : table.columns)
    if (!c.in_space || dimension == 3) columns.push_back(fmt::format("{} {}", c.name, c.type));
  return fmt::format("CREATE TABLE {}_rows ({});\n", table.name, fmt::join(columns, ", "));
}

/// The + keeps SQLite from finding rows by what a query asks of a column: an index of its own making, over all rows, looks
/// cheaper to it than the few rows of a rock.
std::string view_of(const RockTable& table, int dimension) {
  std::string columns;
  for (const RockTable::Column& c : table.columns)
    columns += c.in_space && dimension == 2 ? fmt::format(", 0.0 AS {}", c.name) : fmt::format(", +r.{0} AS {0}", c.name);
  return fmt::format(
      "CREATE VIEW {1} AS SELECT point, trial, rock{2} FROM rocks CROSS JOIN rows_of_rock AS own ON own.rowid = rocks.rowid "
      "CROSS JOIN {0}_rows AS r ON r.rowid BETWEEN own.first_{0} AND own.last_{0};\n",
      table.name, table.view, columns);
}

}  // namespace

int RockTable::width(int dimension) const {
  return static_cast<int>(std::count_if(columns.begin(), columns.end(), [&](const Column& c) { return !c.in_space || dimension == 3; }));
}

std::string rock_tables_schema(int dimension) {
  std::string schema =
      "CREATE TABLE rows_of_rock (first_input INTEGER, last_input INTEGER, first_impact INTEGER, last_impact INTEGER, "
      "first_trajectory INTEGER, last_trajectory INTEGER);\n";
  for (const RockTable* table : {&input_table, &impact_table, &trajectory_table})
    schema += table_of(*table, dimension) + view_of(*table, dimension);
  return schema;
}

}  // namespace flyrock
