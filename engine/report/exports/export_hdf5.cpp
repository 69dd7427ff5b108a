#include "report/exports/export_hdf5.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "files/safe_file.h"
#include "report/exports/exported_tables.h"
#include "report/tables/sqlite.h"
#include "solver/hdf5_file.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> columns_of(const SqliteReader& database, const ExportedTable& table) {
  Query rows(database, table.select("*") + " LIMIT 0");
  std::vector<std::string> names;
  for (int c = 0; c < rows.columns(); ++c) names.push_back(rows.name(c));
  return names;
}

enum class ColumnType { whole, real, text };

/// Of its values: real where it has numbers with a fraction, missing values or no value.
ColumnType type_of(const SqliteReader& database, const ExportedTable& table, const std::string& column) {
  Query row(database, fmt::format("SELECT max(typeof({0}) = 'text'), min(typeof({0}) = 'integer') FROM {1}",
                                  column, table.name));
  if (!row.next() || row.type(0) == SQLITE_NULL) return ColumnType::real;
  return row.whole(0) ? ColumnType::text : row.whole(1) ? ColumnType::whole : ColumnType::real;
}

/// The values of a column, each by `value` of its row.
template <class Value, class Get>
std::vector<Value> values_of(const SqliteReader& database, const std::string& select, Get value) {
  std::vector<Value> values;
  for (Query row(database, select); row.next();) values.push_back(value(row));
  return values;
}

/// One pass over the table for each column: memory holds one of them.
void write_column(Hdf5File& file, const SqliteReader& database, const ExportedTable& table,
                  const std::string& column) {
  const std::string quoted = "\"" + column + "\"", path = "/" + table.name + "/" + column;
  const std::string select = table.select(quoted);
  switch (type_of(database, table, quoted)) {
    case ColumnType::whole:
      return file.write(
          path, values_of<std::int64_t>(database, select, [](const Query& row) { return row.whole(0); }));
    case ColumnType::text:
      return file.write(
          path, values_of<std::string>(database, select, [](const Query& row) { return row.text(0); }));
    case ColumnType::real:
      return file.write(path, values_of<double>(database, select, [](const Query& row) {
                          return row.type(0) == SQLITE_NULL ? std::numeric_limits<double>::quiet_NaN()
                                                            : row.real(0);
                        }));
  }
}

}  // namespace

std::vector<fs::path> export_hdf5(const fs::path& results, const fs::path& folder) {
  const SqliteReader database(results);
  make_folder(folder);
  const fs::path path = folder / "results.h5";
  try {
    Hdf5File file = Hdf5File::create(temporary_name(path).string());
    for (const ExportedTable& table : exported_tables())
      for (const std::string& column : columns_of(database, table))
        write_column(file, database, table, column);
  } catch (const FileError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw FileError(error.what());
  }
  commit_file(path);
  return {path};
}

}  // namespace flyrock
