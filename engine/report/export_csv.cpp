#include "report/export_csv.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "batch/safe_file.h"
#include "report/csv.h"
#include "report/sqlite.h"

namespace flyrock {

namespace {

struct Table {
  const char* name;
  const char* rows;
};

// The view returns the rows of a rock in the order in which they were written: report/rock_rows.h.
constexpr std::array<Table, 25> tables = {{
    {"points", "SELECT * FROM points ORDER BY rowid"},
    {"sweep", "SELECT * FROM sweep ORDER BY rowid"},
    {"parts", "SELECT * FROM parts ORDER BY rowid"},
    {"ground", "SELECT * FROM ground ORDER BY rowid"},
    {"grounds", "SELECT * FROM grounds ORDER BY rowid"},
    {"ground_vertices", "SELECT * FROM ground_vertices ORDER BY rowid"},
    {"ground_triangles", "SELECT * FROM ground_triangles ORDER BY rowid"},
    {"rocks", "SELECT * FROM rocks ORDER BY rowid"},
    {"inputs", "SELECT * FROM inputs ORDER BY point, trial, rock"},
    {"impacts", "SELECT * FROM impacts ORDER BY point, trial, rock"},
    {"trajectories", "SELECT * FROM trajectories ORDER BY point, trial, rock"},
    {"shapes", "SELECT * FROM shapes ORDER BY point, trial, rock"},
    {"gates", "SELECT * FROM gates ORDER BY rowid"},
    {"barriers", "SELECT * FROM barriers ORDER BY rowid"},
    {"trees", "SELECT * FROM trees ORDER BY rowid"},
    {"stems", "SELECT * FROM stems ORDER BY rowid"},
    {"fixtures", "SELECT * FROM fixtures ORDER BY rowid"},
    {"fixture_shapes", "SELECT * FROM fixture_shapes ORDER BY rowid"},
    {"series_bodies", "SELECT * FROM series_bodies ORDER BY rowid"},
    {"series_contacts", "SELECT * FROM series_contacts ORDER BY rowid"},
    {"series_solves", "SELECT * FROM series_solves ORDER BY rowid"},
    {"envelopes", "SELECT * FROM envelopes ORDER BY rowid"},
    {"map_grids", "SELECT * FROM map_grids ORDER BY rowid"},
    {"maps", "SELECT * FROM maps ORDER BY rowid"},
    {"expectations", "SELECT * FROM expectations ORDER BY rowid"},
}};

/// A CSV line with `field` of each column.
template <class Field>
std::string line_of(const Query& row, Field field) {
  std::string line;
  for (int c = 0; c < row.columns(); ++c) {
    if (c > 0) line += ',';
    line += field(c);
  }
  return line + '\n';
}

std::string value_text(const Query& row, int column) {
  switch (row.type(column)) {
    case SQLITE_INTEGER:
      return fmt::format("{}", row.whole(column));
    case SQLITE_FLOAT:
      return csv_number(row.real(column));
    case SQLITE_TEXT:
      return csv_text(row.text(column));
    default:
      return "";
  }
}

void write_table(const SqliteReader& database, const Table& table, const std::filesystem::path& path) {
  Query row(database, table.rows);
  FileWriter file(path);
  file.write(line_of(row, [&](int c) { return row.name(c); }));
  while (row.next()) file.write(line_of(row, [&](int c) { return value_text(row, c); }));
  file.commit();
}

}  // namespace

std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder) {
  const SqliteReader database(results);
  make_folder(folder);
  std::vector<std::filesystem::path> files;
  for (const Table& table : tables) {
    files.push_back(folder / (std::string(table.name) + ".csv"));
    write_table(database, table, files.back());
  }
  return files;
}

}  // namespace flyrock
