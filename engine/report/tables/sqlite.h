#pragma once
// The part of SQLite that results.db needs: a file that is built once with prepared insertions, and queries
// of an existing file.

#include <sqlite3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>

namespace flyrock {

/// An open database. It is built under a temporary name and not synced meanwhile. A journal would only cost
/// time, because an incomplete file is deleted and built again.
class SqliteFile {
 public:
  /// This and all other functions throw FileError.
  explicit SqliteFile(std::filesystem::path path);
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  /// Executes one or several statements without results.
  void execute(const std::string& sql);
  /// Closes the file, syncs it and renames it to its final name. All statements must be destroyed first.
  void commit();

  [[noreturn]] void fail() const;
  sqlite3* handle() const { return database_; }

 private:
  std::filesystem::path path_, temporary_;
  sqlite3* database_ = nullptr;
};

/// A prepared statement, with the values for its `?`.
class Statement {
 public:
  Statement(const SqliteFile& file, const std::string& sql);
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Fills the next `?` after those filled since the last step: whole numbers, doubles (NULL if not finite)
  /// and texts. Texts are not copied and must live until the step.
  template <class... Values>
  void put(const Values&... values) {
    (bind(values), ...);
  }
  /// Throws FileError.
  void step();

 private:
  void bind(double value) {
    if (std::isfinite(value))
      sqlite3_bind_double(statement_, ++filled_, value);
    else
      sqlite3_bind_null(statement_, ++filled_);
  }
  void bind(std::string_view value) {
    sqlite3_bind_text(statement_, ++filled_, value.data(), static_cast<int>(value.size()), SQLITE_STATIC);
  }
  template <class Whole>
  requires std::is_integral_v<Whole>
  void bind(Whole value) { sqlite3_bind_int64(statement_, ++filled_, static_cast<sqlite3_int64>(value)); }

  const SqliteFile& file_;
  sqlite3_stmt* statement_ = nullptr;
  int filled_ = 0;
};

/// Inserts rows into a table.
class Insertion {
 public:
  Insertion(const SqliteFile& file, const std::string& table, int columns);

  /// Inserts the values of one row.
  template <class... Values>
  void row(const Values&... values) {
    one_.put(values...);
    one_.step();
  }

  /// Inserts one row for each record; `put(Statement&, const Record&)` puts its values. Texts must outlive
  /// the call.
  template <class Records, class Put>
  void rows(const Records& records, Put put) {
    std::size_t i = 0;
    for (; i + at_once <= records.size(); many_.step())
      for (const std::size_t end = i + at_once; i < end; ++i) put(many_, records[i]);
    for (; i < records.size(); one_.step(), ++i) put(one_, records[i]);
  }

 private:
  static constexpr std::size_t at_once =
      32;  ///< rows in one statement; fewer statements save a third of the time

  Statement one_, many_;
};

/// A database that is only read, even if its folder cannot be written.
class SqliteReader {
 public:
  /// Throws UnreadableFile.
  explicit SqliteReader(std::filesystem::path path);
  ~SqliteReader() { sqlite3_close(database_); }
  SqliteReader(const SqliteReader&) = delete;
  SqliteReader& operator=(const SqliteReader&) = delete;

  [[noreturn]] void fail() const;
  sqlite3* handle() const { return database_; }

 private:
  std::filesystem::path path_;
  sqlite3* database_ = nullptr;
};

/// A SELECT, read row by row. Columns count from 0.
class Query {
 public:
  /// Throws UnreadableFile; so does next().
  Query(const SqliteReader& file, const std::string& sql);
  ~Query() { sqlite3_finalize(statement_); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  /// Goes to the next row; false after the last one.
  bool next();

  int columns() const { return sqlite3_column_count(statement_); }
  std::string name(int column) const { return sqlite3_column_name(statement_, column); }
  /// SQLITE_NULL, SQLITE_INTEGER, SQLITE_FLOAT or SQLITE_TEXT.
  int type(int column) const { return sqlite3_column_type(statement_, column); }
  double real(int column) const { return sqlite3_column_double(statement_, column); }
  std::int64_t whole(int column) const { return sqlite3_column_int64(statement_, column); }
  std::string text(int column) const;

 private:
  const SqliteReader& file_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace flyrock
