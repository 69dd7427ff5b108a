// Folders that a run left: shards as `merge` reads them, results as `report`, `export` and `run --resume` do.

#include <sqlite3.h>
#include <zlib.h>

#include <filesystem>
#include <map>
#include <stdexcept>

#include "cli/dispatch.h"
#include "corpus.h"
#include "files/safe_file.h"
#include "host/session.h"
#include "host/share.h"
#include "kind.h"
#include "load/checksums.h"
#include "mutate_text.h"

namespace flyrock::fuzz {

namespace fs = std::filesystem;

namespace {

const char* const scenario_file = "tests/fuzz/corpus/scenarios/fences.yaml";

using Files = std::map<std::string, std::string>;  ///< bytes by name

/// The files that a command leaves in a folder: made once, mutated again and again.
Files files_of_run(const cli::Arguments& options) {
  write_here("s.yaml", read_source(scenario_file));
  cli::Arguments arguments = {"run", "s.yaml", "-o", "made", "--force", "--quiet", "-j", "1"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  if (cli::dispatch(arguments) != cli::done) throw std::runtime_error("the sound scenario does not run");
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator("made"))
    if (entry.is_regular_file() && entry.path().extension() != ".html")
      files[fs::relative(entry.path(), "made").string()] = read_file(entry.path());
  fs::remove_all("made");
  // The scenario's whole path is not the same in the next run.
  if (std::string& request = files["chunks/request.json"]; !request.empty())
    request.replace(request.find(fs::current_path().string()), fs::current_path().string().size(), "/quarry");
  else
    files.erase("chunks/request.json");
  return files;
}

void write_folder(const std::string& folder, const Files& files) {
  for (const auto& [name, bytes] : files) write_here(folder + "/" + name, bytes);
}

std::vector<std::string> names_with(const Files& files, const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : files)
    if (name.ends_with(extension)) names.push_back(name);
  return names;
}

std::vector<std::string> names_without(const Files& files, const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : files)
    if (!name.ends_with(extension)) names.push_back(name);
  return names;
}

std::uint64_t word_at(const std::string& bytes, std::size_t at) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < 8; ++i)
    word |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return word;
}

void set_word(std::string& bytes, std::size_t at, std::uint64_t word) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<char>(word >> (8 * i));
}

constexpr std::size_t chunk_header =
    8 + 8 + 8 + 64 + 4 * 8;  // magic, format, hash with its length, the range

/// Makes the checksums of a chunk right again, as a hostile hand would: the tables behind them are then read.
void seal(std::string& bytes) {
  for (std::size_t at = chunk_header; at + 8 <= bytes.size();) {
    const std::uint64_t length = word_at(bytes, at);
    at += 8;
    if (length > bytes.size() - at || bytes.size() - at - length < 8) return;
    set_word(bytes, at + length,
             ::crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data() + at), length));
    at += length + 8;
  }
}

class Shards : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    Files files = shard_;
    if (dice.one_in(4)) {
      std::string& text = files[dice.pick(texts_)];
      dice.one_in(4) ? mutate_bytes(text, dice) : mutate_text(text, dictionary_, dice);
    } else {
      std::string& chunk = files[dice.pick(chunks_)];
      const bool sealed = !dice.one_in(4);
      mutate_bytes(chunk, dice, sealed ? chunk_header : 0);
      if (sealed) seal(chunk);
    }
    write_folder("shard", files);
    write_here("s.yaml", scenario_);
    call({"status", "shard"}, ErrorForm::named);
    call({"merge", "shard", "-o", "out", "--scenario", "s.yaml", "--force", "--quiet"}, ErrorForm::named);
  }

 private:
  Dictionary dictionary_ = make_dictionary(LuaSession(share_folder()).registry());
  std::string scenario_ = read_source(scenario_file);
  Files shard_ = files_of_run({"--shard", "1/1"});
  std::vector<std::string> chunks_ = names_with(shard_, ".chunk"), texts_ = names_with(shard_, ".json");
};

/// A database in a file, for statements without results; what SQLite refuses is no matter.
void change_database(const std::string& file, const std::vector<std::string>& statements) {
  sqlite3* database = nullptr;
  if (sqlite3_open(file.c_str(), &database) == SQLITE_OK)
    for (const std::string& statement : statements)
      sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr);
  sqlite3_close(database);
}

struct Column {
  std::string table, name;
};

/// The columns of all tables of a database.
std::vector<Column> columns_of(const std::string& file) {
  std::vector<Column> columns;
  sqlite3* database = nullptr;
  const auto add = [](void* list, int, char** values, char**) {
    static_cast<std::vector<Column>*>(list)->push_back({values[0], values[1]});
    return 0;
  };
  if (sqlite3_open(file.c_str(), &database) == SQLITE_OK)
    sqlite3_exec(database,
                 "SELECT m.name, c.name FROM sqlite_master m, pragma_table_info(m.name) c WHERE m.type = "
                 "'table' ORDER BY 1, 2",
                 add, &columns, nullptr);
  sqlite3_close(database);
  return columns;
}

class Results : public Kind {
 public:
  Results() {
    write_folder("made", result_);
    columns_ = columns_of("made/results.db");
    fs::remove_all("made");
  }

  void attempt(Dice& dice, Calls& call) override {
    Files files = result_;
    const std::size_t way = dice.below(4);
    if (way == 0) mutate_bytes(files["results.db"], dice);
    if (way == 1) {
      std::string& text = files[dice.pick(texts_)];
      dice.one_in(4) ? mutate_bytes(text, dice) : mutate_text(text, dictionary_, dice);
    }
    write_folder("result", files);
    if (way >= 2) change_database("result/results.db", statements(dice));
    if (!dice.one_in(4)) write_checksums("result");  // a hostile hand sums up what it has changed
    write_here("s.yaml", scenario_);
    call({"report", "result"}, ErrorForm::named);
    call({"export", "result", "--to", "csv"}, ErrorForm::named);
    call({"export", "result", "--to", "vtk"}, ErrorForm::named);
    call({"export", "result", "--to", "geojson"}, ErrorForm::named);
    call({"run", "s.yaml", "-o", "result", "--resume", "--quiet", "-j", "1"}, ErrorForm::named);
  }

 private:
  std::vector<std::string> statements(Dice& dice) const {
    static const std::vector<const char*> values = {"NULL",   "1e300", "-1",      "9223372036854775807",
                                                    "'oops'", "''",    "x'00ff'", "0"};
    const Column& column = dice.pick(columns_);
    switch (dice.below(6)) {
      case 0:
        return {"DROP TABLE " + column.table};
      case 1:
        return {"DELETE FROM " + column.table + " WHERE rowid % 2 = 0"};
      case 2:
        return {"ALTER TABLE " + column.table + " RENAME COLUMN " + column.name + " TO other"};
      case 3:
        return {"INSERT INTO " + column.table + " SELECT * FROM " + column.table};
      default:
        return {"UPDATE " + column.table + " SET " + column.name + " = " + dice.pick(values)};
    }
  }

  Dictionary dictionary_ = make_dictionary(LuaSession(share_folder()).registry());
  std::string scenario_ = read_source(scenario_file);
  Files result_ = files_of_run({});
  std::vector<std::string> texts_ = names_without(result_, ".db");
  std::vector<Column> columns_;
};

}  // namespace

std::unique_ptr<Kind> make_chunk_kind() { return std::make_unique<Shards>(); }
std::unique_ptr<Kind> make_result_kind() { return std::make_unique<Results>(); }

}  // namespace flyrock::fuzz
