#include "report/tables/sqlite.h"

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <vector>

#include "files/safe_file.h"

namespace flyrock {

namespace {

/// INSERT INTO <table> VALUES (?, ..., ?), ..., (?, ..., ?)
std::string insert_into(const std::string& table, int columns, std::size_t rows) {
  const std::vector<std::string> values(static_cast<std::size_t>(columns), "?");
  const std::vector<std::string> each(rows, fmt::format("({})", fmt::join(values, ", ")));
  return fmt::format("INSERT INTO {} VALUES {}", table, fmt::join(each, ", "));
}

/// The way to the disk without locks of SQLite's own, which some file systems do not have. A database is
/// built under a name that only its run uses, and no program changes it afterwards.
constexpr const char* without_locks = "unix-none";

/// Why SQLite refused, in our own words. SQLite's texts would make a user look for a bug in the database
/// program.
std::string reason(sqlite3* database) {
  const int code = database ? sqlite3_errcode(database) & 0xff : SQLITE_NOMEM;
  switch (code) {
    case SQLITE_NOMEM:
      return "not enough memory";
    case SQLITE_FULL:
      return "the disk is full, or the file larger than it may be";
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
      if (const int system = sqlite3_system_errno(database)) return std::strerror(system);
      return "the disk does not answer";
    default:
      return fmt::format("SQLite refuses with its code {}", code);
  }
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path, sqlite3* database) {
  throw FileError(fmt::format("cannot write {}: {}", path.string(), reason(database)));
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, sqlite3* database) {
  const int code = database ? sqlite3_errcode(database) & 0xff : SQLITE_NOMEM;
  // SQLITE_ERROR means a missing table, because our own statements have no other error.
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR)
    throw UnreadableFile(
        fmt::format("{} is damaged: it is not the database that a run writes", path.string()));
  throw UnreadableFile(fmt::format("cannot read {}: {}", path.string(), reason(database)));
}

}  // namespace

SqliteFile::SqliteFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(temporary_name(path_)) {
  std::error_code code;  // left by a killed run
  std::filesystem::remove(temporary_, code);
  if (sqlite3_open_v2(temporary_.c_str(), &database_,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX,
                      without_locks) != SQLITE_OK) {
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> closed(database_, sqlite3_close);
    fail_to_write(path_, database_);
  }
  // Sorting for an index takes 250 pages of memory, here 2 MB.
  execute(
      "PRAGMA page_size = 8192; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA locking_mode = "
      "EXCLUSIVE; BEGIN");
}

SqliteFile::~SqliteFile() {
  if (!database_) return;
  sqlite3_close(database_);
  std::error_code code;
  std::filesystem::remove(temporary_, code);
}

void SqliteFile::execute(const std::string& sql) {
  if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void SqliteFile::commit() {
  execute("COMMIT");
  if (sqlite3_close(database_) != SQLITE_OK) fail();
  database_ = nullptr;
  commit_file(path_);
}

void SqliteFile::fail() const { fail_to_write(path_, database_); }

Statement::Statement(const SqliteFile& file, const std::string& sql) : file_(file) {
  if (sqlite3_prepare_v2(file.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) file.fail();
}

SqliteReader::SqliteReader(std::filesystem::path path) : path_(std::move(path)) {
  if (sqlite3_open_v2(path_.c_str(), &database_, SQLITE_OPEN_READONLY, without_locks) == SQLITE_OK) return;
  const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> closed(database_, sqlite3_close);
  fail_to_read(path_, database_);
}

void SqliteReader::fail() const { fail_to_read(path_, database_); }

Query::Query(const SqliteReader& file, const std::string& sql) : file_(file) {
  if (sqlite3_prepare_v2(file.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) file.fail();
}

bool Query::next() {
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) file_.fail();
  return code == SQLITE_ROW;
}

std::string Query::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

void Statement::step() {
  if (sqlite3_step(statement_) != SQLITE_DONE) file_.fail();
  sqlite3_reset(statement_);
  filled_ = 0;
}

Insertion::Insertion(const SqliteFile& file, const std::string& table, int columns)
    : one_(file, insert_into(table, columns, 1)), many_(file, insert_into(table, columns, at_once)) {}

}  // namespace flyrock
