#include "report/exports/export_csv.h"

#include <fmt/format.h>

#include <string>

#include "files/safe_file.h"
#include "report/tables/csv.h"
#include "report/tables/record_tables.h"
#include "report/tables/sqlite.h"

namespace flyrock {

namespace {

/// The tables that are not made of rows of trials, and the view of inputs with their paths.
constexpr const char* other_tables[] = {
    "points", "sweep", "parts",     "ground",    "grounds", "ground_vertices", "ground_triangles", "inputs",
    "stems",  "zones", "envelopes", "map_grids", "maps",    "expectations"};

/// A view returns the rows of a rock in the order in which they were written: report/tables/record_tables.h.
struct Exported {
  std::string name;
  bool is_view = false;
};

std::vector<Exported> exported_tables() {
  std::vector<Exported> tables;
  for (const std::string name : other_tables) tables.push_back({name, name == "inputs"});
  visit_tables(none_of_the_records, [&](const Table& table, const auto&, auto) {
    if (table.name != std::string_view("drawn")) tables.push_back({table.name, table.many_rows != nullptr});
  });
  return tables;
}

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

void write_table(const SqliteReader& database, const Exported& table, const std::filesystem::path& path) {
  Query row(database, fmt::format("SELECT * FROM {} ORDER BY {}", table.name,
                                  table.is_view ? "point, trial, rock" : "rowid"));
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
  for (const Exported& table : exported_tables()) {
    files.push_back(folder / (table.name + ".csv"));
    write_table(database, table, files.back());
  }
  return files;
}

}  // namespace flyrock
