#pragma once
// The rows of a results.db as text.

#include <sqlite3.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace flyrock::test {

/// One line for each row, values separated by "|". If the query fails, the test fails.
inline std::vector<std::string> query(const std::filesystem::path& database, const std::string& sql) {
  sqlite3* file = nullptr;
  REQUIRE(sqlite3_open_v2(database.c_str(), &file, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  INFO(sql);
  const int prepared = sqlite3_prepare_v2(file, sql.c_str(), -1, &statement, nullptr);
  INFO(sqlite3_errmsg(file));
  REQUIRE(prepared == SQLITE_OK);
  std::vector<std::string> rows;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    std::string row;
    for (int c = 0; c < sqlite3_column_count(statement); ++c) {
      const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, c));
      if (c > 0) row += '|';
      row += text ? text : "NULL";
    }
    rows.push_back(row);
  }
  sqlite3_finalize(statement);
  sqlite3_close(file);
  return rows;
}

/// All rows of all tables, in the order of writing.
inline std::vector<std::string> all_rows(const std::filesystem::path& database) {
  std::vector<std::string> rows;
  for (const std::string& table :
       query(database, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name"))
    for (const std::string& row : query(database, "SELECT * FROM " + table + " ORDER BY rowid"))
      rows.push_back(table + ": " + row);
  return rows;
}

}  // namespace flyrock::test
