// A flipped bit, a file that is cut short, a chunk that is lost: each is told, none is read as if it were a
// result.

#include <random>

#include "same_result.h"

using namespace flyrock::test;

namespace {

/// Words of the libraries that read files for flyrock.
bool names_a_library(const std::string& text) {
  for (const char* word : {"sqlite", "SQLite", "malformed", "disk image", "json.exception", "parse_error",
                           "basic_ios", "what()", "std::"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

std::string with_flipped_bit(std::string bytes, std::mt19937& random) {
  const std::size_t bit = std::uniform_int_distribution<std::size_t>(0, 8 * bytes.size() - 1)(random);
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
  return bytes;
}

/// A file of a folder with other bytes, until the end of the scope.
class Damage {
 public:
  Damage(const Folder& folder, const std::string& file, const std::string& bytes)
      : folder_(folder), file_(file), whole_(read(folder.path() / file)) {
    folder.write(file, bytes);
  }
  ~Damage() { folder_.write(file_, whole_); }
  Damage(const Damage&) = delete;
  Damage& operator=(const Damage&) = delete;

 private:
  const Folder& folder_;
  std::string file_, whole_;
};

constexpr const char* readers[] = {"report r", "export r --to csv -o tables",
                                   "run s.yaml --resume --quiet -o r"};

}  // namespace

TEST_CASE("A flipped bit in a file of a result is exit code 2 and one line, whichever command reads it") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  std::mt19937 random(11);
  for (const std::string file : {"r/results.db", "r/manifest.json", "r/summary.json", "r/rocks.csv",
                                 "r/last_states.csv", "r/SHA256SUMS"})
    for (const char* reader : readers) {
      const Damage damage(folder, file, with_flipped_bit(read(folder.path() / file), random));
      const Output output = call(folder, reader);
      INFO(file << ", " << reader << ": " << output.err);
      CHECK(output.code == 2);
      CHECK(one_line(output.err));
      CHECK_FALSE(names_a_library(output.err));
    }
  CHECK_FALSE(folder.has("tables"));
  for (const char* reader : readers) CHECK(call(folder, reader).code == 0);
}

TEST_CASE("A file of a result that is cut short, empty or no database is exit code 2 and one line") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  const std::string database = read(folder.path() / "r/results.db");
  for (const std::string& bytes :
       {std::string(), std::string("no database"), database.substr(0, database.size() / 2)}) {
    const Damage damage(folder, "r/results.db", bytes);
    for (const char* reader : {"report r", "export r --to vtk -o paraview"}) {
      const Output output = call(folder, reader);
      CHECK(output.code == 2);
      CHECK(output.err ==
            "error: r/results.db is damaged: its SHA-256 is not the one that the run wrote into SHA256SUMS; "
            "run the scenario "
            "again, with --force or -o DIR\n");
    }
  }
  fs::remove(folder.path() / "r/results.db");
  const Output gone = call(folder, "report r");
  CHECK(gone.code == 2);
  CHECK(gone.err == "error: cannot read r/results.db: No such file or directory\n");
}

TEST_CASE("A database that is damaged under a right checksum is exit code 2 as well, in our words") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  std::string database = read(folder.path() / "r/results.db");
  for (std::size_t at = 200; at < database.size(); at += 37) database[at] = 'x';
  folder.write("r/results.db", database);
  REQUIRE(
      shell(folder,
            "cd r && sha256sum last_states.csv manifest.json results.db rocks.csv summary.json > SHA256SUMS")
          .code == 0);
  for (const char* reader : {"report r", "export r --to csv -o tables", "export r --to vtk -o paraview"}) {
    const Output output = call(folder, reader);
    CHECK(output.code == 2);
    CHECK(output.err == "error: r/results.db is damaged: it is not the database that a run writes\n");
  }
}

TEST_CASE("The checksums are those of sha256sum, and the same however the result came about") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r -j1").code == 0);
  const Output check = shell(folder, "cd r && sha256sum -c SHA256SUMS");
  CHECK(check.code == 0);
  CHECK(check.out ==
        "last_states.csv: OK\nmanifest.json: OK\nresults.db: OK\nrocks.csv: OK\nsummary.json: OK\n");
  for (const char* shard : {"1", "2"})
    REQUIRE(call(folder, std::string("run s.yaml --quiet -j2 --shard ") + shard + "/2 -o s" + shard).code ==
            0);
  REQUIRE(call(folder, "merge s2 s1 -o m --quiet").code == 0);
  CHECK(read(folder.path() / "m/SHA256SUMS") == read(folder.path() / "r/SHA256SUMS"));
}

TEST_CASE("A flipped bit in a shard is exit code 2, or the merged result is what it was") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  for (const char* shard : {"1", "2"})
    REQUIRE(call(folder, std::string("run s.yaml --quiet --shard ") + shard + "/2 -o s" + shard).code == 0);
  std::mt19937 random(5);
  int refused = 0;
  for (const std::string file :
       {"s1/manifest.json", "s1/chunks/request.json", "s2/chunks/p0-c1.chunk", "s2/chunks/request.json"})
    for (int flip = 0; flip < 3; ++flip) {
      const Damage damage(folder, file, with_flipped_bit(read(folder.path() / file), random));
      const Output output = call(folder, "merge s1 s2 -o m --quiet --force");
      INFO(file << ": " << output.err);
      CHECK_FALSE(names_a_library(output.err));
      if (output.code == 0) {
        CHECK(read(folder.path() / "m/SHA256SUMS") == read(folder.path() / "whole/SHA256SUMS"));
      } else {
        CHECK(output.code == 2);
        ++refused;
      }
    }
  CHECK(refused > 5);
}

TEST_CASE("A merge of shards of which one has lost a chunk is made, says so and is not exit code 0") {
  const Folder folder;
  folder.write("s.yaml", bench);
  for (const char* shard : {"1", "2"})
    REQUIRE(call(folder, std::string("run s.yaml --quiet --shard ") + shard + "/2 -o s" + shard).code == 0);
  fs::remove(folder.path() / "s2/chunks/p0-c3.chunk");
  const Output lost = call(folder, "merge s1 s2 -o m --quiet");
  CHECK(lost.code == 3);
  CHECK(lost.err ==
        "error: the run ended early: 1 of 4 chunks are missing, from trial 3 of point 0 on\n"
        "error: s2 lacks 1 of its 2 chunks: flyrock run s.yaml --shard 2/2 --resume -o s2\n");
  CHECK(read(folder.path() / "m/summary.json").find("\"complete\": false") != std::string::npos);
  const Output partial = call(folder, "merge s1 s2 -o partial --quiet --partial");
  CHECK(partial.code == 0);
  CHECK(partial.err ==
        "warning: the result is not complete: 1 of 4 chunks are missing, from trial 3 of point 0 on\n"
        "warning: s2 lacks 1 of its 2 chunks: flyrock run s.yaml --shard 2/2 --resume -o s2\n");
  fs::rename(folder.path() / "s2/chunks/p0-c1.chunk", folder.path() / "p0-c1.chunk");
  fs::rename(folder.path() / "s1/chunks/p0-c2.chunk", folder.path() / "s2/chunks/p0-c2.chunk");
  const Output moved = call(folder, "merge s1 s2 -o n --quiet");
  CHECK(moved.code == 2);
  CHECK(moved.err.find("s2 holds p0-c2.chunk, which is not a chunk of shard 2 of 2") != std::string::npos);
}

TEST_CASE("A merge without a shard is exit code 3, and names the shard and the command that runs it") {
  const Folder folder;
  folder.write("my bench.yaml", bench);
  const std::string run =
      "run 'my bench.yaml' --quiet --seed 5 --set 'materials.rock.friction.mu=0.5' --shard ";
  for (const std::string shard : {"1", "2", "3"})
    REQUIRE(call(folder, run + shard + "/3 -o s" + shard).code == 0);
  const std::string command =
      "flyrock run 'my bench.yaml' --set materials.rock.friction.mu=0.5 --seed 5 --shard 2/3";
  const Output some = call(folder, "merge s1 s3 -o some --quiet");
  CHECK(some.code == 3);
  CHECK(some.err ==
        "error: the run ended early: 1 of 4 chunks are missing, from trial 1 of point 0 on\n"
        "error: shard 2 of 3 is missing: " +
            command + "\n");
  CHECK(folder.has("some/report.html"));
  const Output partial = call(folder, "merge s1 s3 -o partial --quiet --partial");
  CHECK(partial.code == 0);
  CHECK(partial.err ==
        "warning: the result is not complete: 1 of 4 chunks are missing, from trial 1 of point 0 on\n"
        "warning: shard 2 of 3 is missing: " +
            command + "\n");
  // The command does what the message promises.
  REQUIRE(call(folder, command.substr(8) + " --quiet -o again").code == 0);
  CHECK(call(folder, "merge s1 again s3 -o all --quiet").code == 0);
  CHECK(call(folder, "merge s1 s2 s3 -o whole --quiet --partial").code == 0);
  CHECK(read(folder.path() / "all/SHA256SUMS") == read(folder.path() / "whole/SHA256SUMS"));
}

TEST_CASE("Shards of different numbers of shards name what they leave") {
  const Folder folder;
  folder.write("s.yaml", bench_with("trials: 4", "trials: 12"));
  for (const std::string shard : {"1/2", "2/6"})
    REQUIRE(call(folder, "run s.yaml --quiet --shard " + shard + " -o s" + shard.substr(0, 1)).code == 0);
  const Output some = call(folder, "merge s1 s2 -o some --quiet");
  CHECK(some.code == 3);
  CHECK(some.err.find("shard 4 of 6 is missing: flyrock run s.yaml --shard 4/6\n") != std::string::npos);
  CHECK(some.err.find("shard 6 of 6 is missing: flyrock run s.yaml --shard 6/6\n") != std::string::npos);
  for (const std::string shard : {"4", "6"})
    REQUIRE(call(folder, "run s.yaml --quiet --shard " + shard + "/6 -o s" + shard).code == 0);
  CHECK(call(folder, "merge s1 s2 s4 s6 -o all --quiet").code == 0);
}

TEST_CASE("More shards than chunks are warned of, and the empty ones are not missed") {
  const Folder folder;
  folder.write("s.yaml", bench);
  const Output last = call(folder, "run s.yaml --quiet --shard 6/6 -o s6");
  CHECK(last.code == 0);
  CHECK(last.err == "warning: --shard 6/6: the run has only 4 chunks: this shard has nothing to do\n");
  const Output first = call(folder, "run s.yaml --quiet --shard 1/6 -o s1");
  CHECK(first.err ==
        "warning: --shard 1/6: the run has only 4 chunks: the shards above 4 have nothing to do\n");
  for (const std::string shard : {"2", "3", "4"})
    REQUIRE(call(folder, "run s.yaml --quiet --shard " + shard + "/6 -o s" + shard).code == 0);
  CHECK(call(folder, "merge s1 s2 s3 s4 -o m --quiet").code == 0);
  CHECK(call(folder, "merge s1 s2 s3 s4 s6 -o n --quiet").code == 0);
}
