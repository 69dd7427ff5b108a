#include "report/database.h"

#include <fmt/format.h>

#include <limits>

#include "batch/inputs.h"
#include "batch/safe_file.h"
#include "report/envelope_data.h"
#include "report/rock_rows.h"
#include "report/tables.h"

namespace flyrock {

namespace {

constexpr const char* schema = R"(
CREATE TABLE points (point INTEGER PRIMARY KEY, trials INTEGER, ground INTEGER);
CREATE TABLE sweep (point INTEGER, path TEXT, value REAL, label TEXT);
CREATE TABLE parts (point INTEGER, part INTEGER, name TEXT);
CREATE TABLE ground (point INTEGER, x_m REAL, y_m REAL, part INTEGER);
CREATE TABLE grounds (ground INTEGER PRIMARY KEY, cell_m REAL, lattice_m REAL);
CREATE TABLE ground_vertices (ground INTEGER, vertex INTEGER, x_m REAL, y_m REAL, z_m REAL);
CREATE TABLE ground_triangles (ground INTEGER, a INTEGER, b INTEGER, c INTEGER, part INTEGER);
CREATE TABLE input_paths (input INTEGER PRIMARY KEY, path TEXT);
CREATE TABLE envelopes (point INTEGER, "group" TEXT, x_m REAL, width_m REAL, rocks INTEGER, height_p50_m REAL,
  height_p95_m REAL, height_max_m REAL, speed_p50_m_s REAL, speed_p95_m_s REAL, speed_max_m_s REAL, energy_p50_J REAL,
  energy_p95_J REAL, energy_max_J REAL);
CREATE TABLE map_grids (point INTEGER PRIMARY KEY, x_m REAL, y_m REAL, cell_m REAL, columns INTEGER, rows INTEGER);
CREATE TABLE report (data TEXT);
CREATE TABLE stems (point INTEGER, tree INTEGER, x_m REAL, y_m REAL, diameter_m REAL, height_m REAL, strength REAL);
CREATE TABLE expectations (number INTEGER, measure TEXT, point INTEGER, computed REAL, kind TEXT, expected REAL,
  expected_high REAL, tolerance REAL, passed INTEGER, reason TEXT);
)";

const std::vector<StoredColumn>& rock_columns() {
  static const auto columns = columns_of<RockRecord>([](auto visit) { visit_rocks(visit); });
  return columns;
}
const std::vector<StoredColumn>& gate_columns() {
  static const auto columns = columns_of<GateRecord>([](auto visit) { visit_gates(visit); });
  return columns;
}
const std::vector<StoredColumn>& barrier_columns() {
  static const auto columns = columns_of<BarrierRecord>([](auto visit) { visit_barriers(visit); });
  return columns;
}

const std::vector<StoredColumn>& tree_columns() {
  static const auto columns = columns_of<TreeRecord>([](auto visit) { visit_trees(visit); });
  return columns;
}

/// `, "mass_kg" REAL, ...`: the declarations of columns that follow others.
std::string declared(const std::vector<StoredColumn>& columns) {
  std::string text;
  for (const auto& [column, type] : columns) text += fmt::format(", \"{}\" {}", column.name, type);
  return text;
}

/// The names and columns of the tables of rows of trials.
const std::vector<std::pair<const char*, std::vector<StoredColumn>>>& trial_tables() {
  static const auto tables = [] {
    std::vector<std::pair<const char*, std::vector<StoredColumn>>> list;
    TrialRecords none;
    visit_trial_tables(none, [&](const char* name, auto& rows, auto visit_columns) {
      using Row = typename std::decay_t<decltype(rows)>::value_type;
      list.emplace_back(name, columns_of<Row>(visit_columns));
    });
    return list;
  }();
  return tables;
}

std::string record_tables_schema() {
  std::string of_trials;
  for (const auto& [name, columns] : trial_tables())
    of_trials += fmt::format("CREATE TABLE {} (point INTEGER, trial INTEGER{});\n", name, declared(columns));
  return of_trials + fmt::format(
                         "CREATE TABLE rocks (point INTEGER{});\n"
                         "CREATE TABLE gates (point INTEGER, trial INTEGER, rock INTEGER{});\n"
                         "CREATE TABLE barriers (point INTEGER, trial INTEGER, rock INTEGER{});\n"
                         "CREATE TABLE trees (point INTEGER, trial INTEGER, rock INTEGER{});\n",
                         declared(rock_columns()), declared(gate_columns()), declared(barrier_columns()),
                         declared(tree_columns()));
}

/// Puts what a table shows for a record. `names`: the names for its indices.
template <class Row>
auto put_into(Statement& to, const Row& row, const std::vector<std::string>& names) {
  return [&to, &row, &names](const Column& column, auto get) {
    if (column.name)
      shown_value(column, member_of(row, get), names, [&](const auto& value) { to.put(value); });
  };
}

template <class Places>
std::vector<std::string> names_of(const Places& places) {
  std::vector<std::string> names;
  for (const auto& place : places) names.push_back(place.name);
  return names;
}

void add_stems(const SqliteFile& file, const Results& results) {
  Insertion rows(file, "stems", 7);
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    if (!point.forest) continue;
    int tree = 0;
    for (const Stem& stem : point.forest->stems())
      rows.row(p, tree++, stem.place.x() + point.terrain.origin.x(),
               stem.place.y() + point.terrain.origin.y(), 2 * stem.radius, stem.height, stem.strength);
  }
}

constexpr const char* inputs_view =
    "CREATE VIEW inputs AS SELECT point, trial, rock, path, nullif(impact, 0) AS impact, value FROM drawn "
    "JOIN input_paths USING (input);";

// Built after the rows, because an index that grows with the rows takes longer.
constexpr const char* indices = R"(
CREATE UNIQUE INDEX rocks_by_rock ON rocks (point, trial, rock);
CREATE INDEX gates_by_rock ON gates (point, trial, rock);
CREATE INDEX barriers_by_rock ON barriers (point, trial, rock);
CREATE INDEX trees_by_rock ON trees (point, trial, rock);
)";

void add_expectations(const SqliteFile& file, const Results& results) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Insertion rows(file, "expectations", 10);
  int number = 0;
  for (const Verdict& v : results.verdicts) {
    const bool between = v.expectation.kind == ExpectKind::between;
    // Absent numbers are NaN, which SQLite stores as NULL.
    rows.row(number++, v.expectation.measure, v.point < 0 ? none : static_cast<double>(v.point), v.computed,
             expect_kind_names[static_cast<std::size_t>(v.expectation.kind)], v.expectation.value,
             between ? v.expectation.high : none, v.tolerance,
             v.judgement == Judgement::not_judged ? none : double(v.judgement == Judgement::passed),
             v.reason);
  }
}

void add_profiles(const SqliteFile& file, const Results& results) {
  Insertion rows(file, "ground", 4);
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const Profile& ground = results.points[p].terrain.profile;
    for (std::size_t i = 0; i < ground.points.size(); ++i) {
      // No segment follows the last point.
      const double part = i < ground.part.size() ? ground.part[i] : std::numeric_limits<double>::quiet_NaN();
      rows.row(p, ground.points[i].x(), ground.points[i].y(), part);
    }
  }
}

void add_grounds(const SqliteFile& file, const std::vector<GroundPicture>& grounds) {
  Insertion rows(file, "grounds", 3), vertices(file, "ground_vertices", 5),
      triangles(file, "ground_triangles", 5);
  for (std::size_t g = 0; g < grounds.size(); ++g) {
    const auto& [mesh, lattice] = grounds[g].stored;
    rows.row(g, grounds[g].cell, lattice);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      vertices.row(g, v, mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      triangles.row(g, a, b, c, mesh.part[t]);
    }
  }
}

void add_envelopes(const SqliteFile& file, const Results& results) {
  Insertion rows(file, "envelopes", 14);
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const std::vector<std::vector<EnvelopeRow>> groups = envelope_rows(results.points[p]);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const EnvelopeRow& row : groups[g]) {
        const auto& [height, speed, energy] = row.levels;
        rows.row(p, results.points[p].groups[g].name, row.x, envelope_width(results.points[p]), row.rocks,
                 height[0], height[1], height[2], speed[0], speed[1], speed[2], energy[0], energy[1],
                 energy[2]);
      }
  }
}

std::string map_table_schema() {
  std::string columns;
  for (std::size_t m = 0; m < map_names.size(); ++m)
    columns += fmt::format(", {} {}", map_names[m], is_count_map(m) ? "INTEGER" : "REAL");
  return fmt::format("CREATE TABLE maps (point INTEGER, \"column\" INTEGER, \"row\" INTEGER{});\n", columns);
}

void add_maps(const SqliteFile& file, const Results& results) {
  Insertion grids(file, "map_grids", 6), rows(file, "maps", 3 + static_cast<int>(map_names.size()));
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PlanGrid& grid = results.points[p].maps.grid;
    if (grid.empty()) continue;
    grids.row(p, grid.low.x(), grid.low.y(), grid.cell, grid.columns, grid.rows);
    const auto columns = static_cast<std::uint32_t>(grid.columns);
    rows.rows(results.points[p].maps.cells, [&](Statement& to, const MapRasters::Cell& cell) {
      to.put(p, cell.index % columns, cell.index / columns);
      for (std::size_t m = 0; m < map_names.size(); ++m) {
        if (is_count_map(m))
          to.put(static_cast<std::int64_t>(cell.values[m]));
        else
          to.put(cell.values[m]);
      }
    });
  }
}

}  // namespace

ResultDatabase::Insertions::Insertions(const SqliteFile& file, int dimension)
    : rocks(file, "rocks", 1 + static_cast<int>(rock_columns().size())),
      rows_of_rock(file, "rows_of_rock", 8),
      inputs(file, "input_rows", input_table().width(dimension)),
      impacts(file, "impact_rows", impact_table().width(dimension)),
      trajectories(file, "trajectory_rows", trajectory_table().width(dimension)),
      shapes(file, "shape_rows", shape_table().width(dimension)),
      gates(file, "gates", 3 + static_cast<int>(gate_columns().size())),
      barriers(file, "barriers", 3 + static_cast<int>(barrier_columns().size())),
      trees(file, "trees", 3 + static_cast<int>(tree_columns().size())) {
  for (const auto& [name, columns] : trial_tables())
    of_trials.emplace_back(file, name, 2 + static_cast<int>(columns.size()));
}

ResultDatabase::ResultDatabase(const std::filesystem::path& path, const Plan& plan)
    : plan_(plan), groups_(group_names(plan.points.front())), file_(path) {
  const int dimension = plan.points.front().dimension;
  file_.execute(schema + map_table_schema() + record_tables_schema() + rock_tables_schema(dimension) +
                inputs_view + fmt::format("PRAGMA user_version = {};", result_format));
  insertions_ = std::make_unique<Insertions>(file_, dimension);
  add_plan();
}

void ResultDatabase::add_plan() {
  add_input_paths();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Insertion sweep(file_, "sweep", 4);
  for (std::size_t p = 0; p < plan_.points.size(); ++p)
    for (std::size_t a = 0; a < plan_.axes.size(); ++a) {
      const SweepAxis& axis = plan_.axes[a];
      const double value = plan_.at[p][a];
      if (axis.is_choice())
        sweep.row(p, axis.path, none, axis.label(value));
      else
        sweep.row(p, axis.path, value, none);
    }
}

/// Stores each path once. Sweep points with different plugins have different inputs; inputs with the same
/// path share its number.
void ResultDatabase::add_input_paths() {
  Insertion paths(file_, "input_paths", 2);
  std::map<std::string, int> known;
  for (const Scenario& point : plan_.points) {
    input_ids_.emplace_back();
    for (const Input& input : inputs_of(point)) {
      const auto [entry, is_new] = known.emplace(input.path, static_cast<int>(known.size()));
      if (is_new) paths.row(entry->second, input.path);
      input_ids_.back().push_back(entry->second);
    }
  }
}

void ResultDatabase::add(int point, const TrialRecords& records) {
  const Scenario& scenario = plan_.points[static_cast<std::size_t>(point)];
  RowsOfRocks inputs(records.inputs, written_.inputs);
  RowsOfRocks impacts(records.impacts, written_.impacts);
  RowsOfRocks trajectories(records.trajectories, written_.trajectories);
  RowsOfRocks shapes(records.shapes, written_.shapes);
  insertions_->rocks.rows(records.rocks, [&](Statement& to, const RockRecord& r) {
    to.put(point);
    visit_rocks(put_into(to, r, groups_));
  });
  insertions_->rows_of_rock.rows(records.rocks, [&](Statement& to, const RockRecord& r) {
    for (const auto& [first, last] : {inputs.of(r), impacts.of(r), trajectories.of(r), shapes.of(r)})
      to.put(first, last);
  });
  const std::vector<std::string> none, gates = names_of(scenario.gates),
                                       barriers = names_of(scenario.barriers);
  const auto stored = [&](auto put) {
    return [put, dimension = scenario.dimension](const Column& column, auto get) {
      if (is_stored(column, dimension)) put(column, get);
    };
  };
  const std::vector<int>& ids = input_ids_[static_cast<std::size_t>(point)];
  insertions_->inputs.rows(records.inputs, [&](Statement& to, InputRecord r) {
    r.input = ids.at(static_cast<std::size_t>(r.input));
    visit_inputs(stored(put_into(to, r, none)));
  });
  insertions_->impacts.rows(records.impacts, [&](Statement& to, const ImpactRecord& r) {
    visit_impacts(stored(put_into(to, r, none)));
  });
  insertions_->trajectories.rows(records.trajectories, [&](Statement& to, const TrajectoryRecord& r) {
    visit_trajectories(stored(put_into(to, r, none)));
  });
  insertions_->shapes.rows(records.shapes, [&](Statement& to, const ShapeRecord& r) {
    visit_shapes(stored(put_into(to, r, none)));
  });
  insertions_->gates.rows(records.gates, [&](Statement& to, const GateRecord& r) {
    to.put(point, r.trial, r.rock);
    visit_gates(put_into(to, r, gates));
  });
  insertions_->barriers.rows(records.barriers, [&](Statement& to, const BarrierRecord& r) {
    to.put(point, r.trial, r.rock);
    visit_barriers(put_into(to, r, barriers));
  });
  insertions_->trees.rows(records.trees, [&](Statement& to, const TreeRecord& r) {
    to.put(point, r.trial, r.rock);
    visit_trees(put_into(to, r, none));
  });
  auto table = insertions_->of_trials.begin();
  visit_trial_tables(records, [&](const char*, const auto& rows, auto visit_columns) {
    (table++)->rows(rows, [&](Statement& to, const auto& r) {
      to.put(point, r.trial);
      visit_columns(put_into(to, r, none));
    });
  });
}

void ResultDatabase::index() { file_.execute(indices); }

void ResultDatabase::finish(const Results& results, const GroundPictures& grounds,
                            const std::string& report) {
  {
    Insertion(file_, "report", 1).row(report);
    Insertion points(file_, "points", 3), parts(file_, "parts", 3);
    for (std::size_t p = 0; p < results.points.size(); ++p) {
      const int ground = grounds.of_point[p];
      points.row(p, results.points[p].trials,
                 ground < 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(ground));
      const std::vector<std::string>& names = results.points[p].terrain.parts;
      for (std::size_t part = 0; part < names.size(); ++part) parts.row(p, part, names[part]);
    }
    add_profiles(file_, results);
    add_grounds(file_, grounds.grounds);
    add_envelopes(file_, results);
    add_maps(file_, results);
    add_stems(file_, results);
    add_expectations(file_, results);
  }
  insertions_.reset();  // because a statement keeps its file open
  file_.commit();
}

std::string stored_report(const std::filesystem::path& path) {
  const SqliteReader file(path);
  Query row(file, "SELECT data FROM report");
  if (!row.next())
    throw UnreadableFile(fmt::format("{} is damaged: it holds no data of a report", path.string()));
  return row.text(0);
}

}  // namespace flyrock
