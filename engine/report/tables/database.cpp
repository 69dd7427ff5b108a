#include "report/tables/database.h"

#include <fmt/format.h>

#include <limits>

#include "batch/inputs.h"
#include "files/safe_file.h"
#include "report/tables/envelope_data.h"
#include "report/tables/record_tables.h"
#include "report/tables/tables.h"
#include "report/tables/zone_region.h"

namespace flyrock {

namespace {

constexpr const char* schema = R"(
CREATE TABLE points (point INTEGER PRIMARY KEY, trials INTEGER, ground INTEGER, series_every_s REAL);
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
CREATE TABLE zones (point INTEGER, zone INTEGER, name TEXT, polygon INTEGER, ring INTEGER, x_m REAL, y_m REAL);
CREATE TABLE report (data TEXT);
CREATE TABLE stems (point INTEGER, tree INTEGER, x_m REAL, y_m REAL, diameter_m REAL, height_m REAL, strength REAL);
CREATE TABLE expectations (number INTEGER, measure TEXT, point INTEGER, computed REAL, kind TEXT, expected REAL,
  expected_high REAL, tolerance REAL, passed INTEGER, reason TEXT);
)";

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

void add_zones(const SqliteFile& file, const Plan& plan, const Results& results,
               const GroundPictures& grounds) {
  Insertion rows(file, "zones", 7);
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const std::vector<Zone>& zones = plan.points[p].terrain.zones;
    const int ground = grounds.of_point[p];
    for (std::size_t z = 0; z < zones.size(); ++z) {
      const auto polygons = region_of(
          zones[z], ground < 0 ? nullptr : &grounds.grounds[static_cast<std::size_t>(ground)].stored.mesh);
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto add_ring = [&](const PlanRing& ring, std::size_t number) {
          for (const Vec2& corner : ring) rows.row(p, z, zones[z].name, i, number, corner.x(), corner.y());
        };
        add_ring(polygons[i].outline, 0);
        for (std::size_t h = 0; h < polygons[i].holes.size(); ++h) add_ring(polygons[i].holes[h], h + 1);
      }
    }
  }
}

constexpr const char* inputs_view =
    "CREATE VIEW inputs AS SELECT point, trial, rock, path, nullif(impact, 0) AS impact, value FROM drawn "
    "JOIN input_paths USING (input);";

// Built after the rows, because an index that grows with the rows takes longer.
constexpr const char* index_statements = R"(
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
    rows.row(number++, compared_text(v.expectation), v.point < 0 ? none : static_cast<double>(v.point),
             v.computed, expect_kind_names[static_cast<std::size_t>(v.expectation.kind)], v.expectation.value,
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
    rows.rows(results.points[p].maps.cells, [&](Statement& to, const MapRasters::Cell& raster) {
      to.put(p, raster.index % columns, raster.index / columns);
      for (std::size_t m = 0; m < map_names.size(); ++m) {
        // A column of INTEGER stores whole numbers as such.
        to.put(raster.values[m]);
      }
    });
  }
}

}  // namespace

ResultDatabase::Insertions::Insertions(const SqliteFile& file, const TableContent& content)
    : rows_of_rock(file, "rows_of_rock", 2 * RowsOfRocks::tables()) {
  visit_tables(none_of_the_records, [&](const Table& table, const auto& rows, auto visit_columns) {
    using Row = typename std::decay_t<decltype(rows)>::value_type;
    tables.emplace_back(file, stored_name(table), stored_width<Row>(table, visit_columns, content));
  });
}

ResultDatabase::ResultDatabase(const std::filesystem::path& path, const Plan& plan)
    : plan_(plan), file_(path), rows_of_rocks_(plan.points.size() > 1) {}

void ResultDatabase::begin(bool weighted) {
  content_ = content_of(plan_.points.front());
  content_.weights = weighted;
  file_.execute(schema + map_table_schema() + record_tables_schema(content_) + inputs_view +
                fmt::format("PRAGMA user_version = {};", result_format));
  insertions_ = std::make_unique<Insertions>(file_, content_);
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
    std::vector<int>& inputs = names_.emplace_back(point).inputs;
    for (const Input& input : inputs_of(point)) {
      const auto [entry, is_new] = known.emplace(input.path, static_cast<int>(known.size()));
      if (is_new) paths.row(entry->second, input.path);
      inputs.push_back(entry->second);
    }
  }
}

void ResultDatabase::add(int point, const TrialRecords& records) {
  const RecordNames& names = names_[static_cast<std::size_t>(point)];
  const std::vector<RowsOfRocks::OfTable> long_tables = rows_of_rocks_.of(records, names, content_);
  auto long_table = long_tables.begin();
  auto insertion = insertions_->tables.begin();
  visit_tables(records, [&](const Table& table, const auto& rows, auto visit_columns) {
    using Row = typename std::decay_t<decltype(rows)>::value_type;
    Insertion& into = *insertion++;
    const auto put_row = [&](Statement& to, const Row& row) {
      const auto put = [&](const Column& column, auto get) {
        if (is_stored(table, column, content_))
          shown_value(column, member_of(row, get), names, [&](const auto& value) { to.put(value); });
      };
      if (!table.many_rows) {
        to.put(point);
        visit_owner<Row>(table, put);
      }
      visit_columns(put);
    };
    if (table.many_rows)
      into.rows((long_table++)->to_write, [&](Statement& to, std::size_t row) { put_row(to, rows[row]); });
    else
      into.rows(rows, put_row);
  });
  insertions_->rows_of_rock.rows(records.rocks, [&](Statement& to, const RockRecord& rock) {
    const auto number = static_cast<std::size_t>(&rock - records.rocks.data());
    for (const RowsOfRocks::OfTable& of_table : long_tables)
      to.put(of_table.of_rock[number].first, of_table.of_rock[number].second);
  });
}

void ResultDatabase::index() { file_.execute(index_statements); }

void ResultDatabase::finish(const Results& results, const GroundPictures& grounds,
                            const std::string& report) {
  {
    Insertion(file_, "report", 1).row(report);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Insertion points(file_, "points", 4), parts(file_, "parts", 3);
    for (std::size_t p = 0; p < results.points.size(); ++p) {
      const int ground = grounds.of_point[p];
      const std::optional<SeriesPlan>& series = plan_.points[p].output.series;
      points.row(p, results.points[p].trials, ground < 0 ? none : static_cast<double>(ground),
                 series ? series->every : none);
      const std::vector<std::string>& names = results.points[p].terrain.parts;
      for (std::size_t part = 0; part < names.size(); ++part) parts.row(p, part, names[part]);
    }
    add_profiles(file_, results);
    add_grounds(file_, grounds.grounds);
    add_envelopes(file_, results);
    add_maps(file_, results);
    add_stems(file_, results);
    add_zones(file_, plan_, results, grounds);
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
