#include "report/exports/export_csv.h"

#include <fmt/format.h>

#include <string>

#include "files/safe_file.h"
#include "report/exports/exported_tables.h"
#include "report/tables/csv.h"
#include "report/tables/sqlite.h"

namespace flyrock {

namespace {

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

void write_table(const SqliteReader& database, const ExportedTable& table,
                 const std::filesystem::path& path) {
  Query row(database, table.select("*"));
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
  for (const ExportedTable& table : exported_tables()) {
    files.push_back(folder / (table.name + ".csv"));
    write_table(database, table, files.back());
  }
  return files;
}

}  // namespace flyrock
