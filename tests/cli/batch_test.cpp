// Threads, resuming and shards: one result, however it came about.

#include "same_result.h"
#include "samples.h"

using namespace flyrock::test;

namespace {

/// Two sweep points of 60 trials.
std::string sweep() {
  std::string text = bench_with("mu: 0.6", "mu: { sweep: [0.5, 0.7] }");
  return text.replace(text.find("trials: 4"), 9, "trials: 60");
}

}  // namespace

TEST_CASE("Any number of threads gives the same bytes") {
  const Folder folder;
  folder.write("s.yaml", sweep());
  for (const char* threads : {"1", "2", "3"}) {
    const Output run = call(folder, std::string("run s.yaml --quiet -o j") + threads + " -j" + threads);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  check_same(folder, "j1", "j2");
  check_same(folder, "j1", "j3");
  CHECK(read(folder.path() / "j2/run.log").find("threads  2") != std::string::npos);
  CHECK(call(folder, "run s.yaml -j0").err.find("-j: `0` is not a whole number of at least 1") !=
        std::string::npos);
}

TEST_CASE("A law in Lua runs in several threads") {
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "mine", form = "newton",
  doc = "Fades with speed; fails at the fourth impact.", source = "a test",
  params = {},
  impact = function(p, contact)
    if contact.impact_number > 3 then error("too many") end
    return 0.4 / (1 + contact.approach_speed / 10), 0
  end,
}
)");
  std::string text = bench_with("{ type: newton, en: 0.3 }", "{ type: mine }");
  text.replace(text.find("trials: 4"), 9, "trials: 120");
  folder.write("s.yaml", "plugins: [law.lua]\n" + text);
  for (const char* threads : {"1", "3"})
    call(folder, std::string("run s.yaml --quiet -o j") + threads + " -j" + threads);
  check_same(folder, "j1", "j3");
  for (const char* threads : {"1", "3"})
    CHECK(call(folder, std::string("run s.yaml --strict -o s") + threads + " -j" + threads).code == 3);
  check_same(folder, "s1", "s3");
}

TEST_CASE("A run that is killed at any moment and resumed gives the same bytes", "[slow]") {
  const Folder folder;
  std::string text = sweep();
  text.replace(text.find("trials: 60"), 10, "trials: 3000");
  folder.write("s.yaml", text);
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  const auto whole =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
  for (int kill = 1; kill <= 10; ++kill)
    call_and_kill(folder, "s.yaml --resume -o killed", whole * ((kill * 37) % 100) / 100);
  const Output resumed = call(folder, "run s.yaml --resume --quiet -o killed");
  INFO(resumed.err);
  CHECK(resumed.code == 0);
  check_same(folder, "whole", "killed");
  const Output again = call(folder, "run s.yaml --resume -o killed");
  CHECK(again.code == 0);
  CHECK(again.out.find("nothing to do, all trials are done") == 0);
}

TEST_CASE("A run that was killed while it removed its chunks is tidied when it is resumed") {
  const Folder folder;
  folder.write("s.yaml", sweep());
  REQUIRE(call(folder, "run s.yaml --quiet -o done").code == 0);
  std::filesystem::create_directory(folder.path() / "done/chunks");
  folder.write("done/chunks/p0-c0.chunk", "left over");
  const Output resumed = call(folder, "run s.yaml --resume -o done");
  CHECK(resumed.code == 0);
  CHECK(resumed.out.find("nothing to do, all trials are done") == 0);
  CHECK_FALSE(folder.has("done/chunks"));
}

TEST_CASE("A million rocks take no more memory than ten thousand", "[heavy]") {
  const Folder folder;
  const auto peak = [&](const std::string& trials) {  // MB
    REQUIRE(
        call(folder,
             "run " FLYROCK_SOURCE_DIR "/tests/bench/many.yaml --quiet --force -j2 -o r --trials " + trials)
            .code == 0);
    const std::string log = read(folder.path() / "r/run.log");
    return std::stod(log.substr(log.find("memory") + 6));
  };
  const double few = peak("10000"), many = peak("1000000");
  WARN("at most " << few << " MB for ten thousand rocks, " << many << " MB for a million");
  // Chunks grow from 100 to 250 trials and the list of chunks to 4000: some 2 MB. A byte kept of each rock
  // would be 1 MB, a double of each 8 MB.
  CHECK(many - few < 4);
  CHECK(many < 40);
}

TEST_CASE("An interrupted run is resumed") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call_and_interrupt(folder, "s.yaml", "out/s/chunks/p0-c0.chunk").code == 130);
  // Of 100,000 trials: another scenario than the file's own 4.
  const Output other = call(folder, "run s.yaml --resume");
  CHECK(other.code == 2);
  CHECK(
      other.err.find("out/s holds a run of another scenario, seed, number of trials or version of flyrock") !=
      std::string::npos);
  CHECK(folder.has("out/s/chunks/p0-c0.chunk"));
  CHECK(call(folder, "run s.yaml --resume --force").err.find("expected one of --resume and --force") !=
        std::string::npos);
  REQUIRE(call(folder, "run s.yaml --force --quiet").code == 0);
  // Nothing there, or nothing in it: a start.
  fs::create_directories(folder.path() / "empty");
  REQUIRE(call(folder, "run s.yaml --resume --quiet -o empty").code == 0);
  REQUIRE(call(folder, "run s.yaml --resume --quiet -o absent").code == 0);
  check_same(folder, "out/s", "empty");
  check_same(folder, "out/s", "absent");
}

TEST_CASE("A terrain file that was edited is another scenario") {
  const Folder folder;
  folder.write("slope.csv", "-20, 10\n0, 10\n3, 0\n300, 0\n");
  folder.write("s.yaml", bench_with("points: [[-20, 10], [0, 10], [3, 0], [300, 0]]", "file: slope.csv"));
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  CHECK(read(folder.path() / "whole/manifest.json").find("\"name\": \"slope.csv\"") != std::string::npos);
  REQUIRE(call(folder, "run s.yaml --quiet --shard 1/2 -o a").code == 0);
  folder.write("slope.csv", "-20, 10\n0, 10\n6, 0\n300, 0\n");
  const Output resumed = call(folder, "run s.yaml --resume -o whole");
  CHECK(resumed.code == 2);
  CHECK(resumed.err.find("whole holds a run of another scenario") != std::string::npos);
  REQUIRE(call(folder, "run s.yaml --quiet --shard 2/2 -o b").code == 0);
  CHECK(call(folder, "merge a b -o m").err.find("a and b are of different scenarios") != std::string::npos);
}

TEST_CASE("Three shards merged are one run", "[slow]") {
  const Folder folder;
  folder.write("s.yaml", sweep());
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Output run = call(folder, std::string("run s.yaml --shard ") + shard);
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK(run.out.find(std::string("shard ") + shard[0] + " of 3: 40 trials in out/s-shard-") == 0);
  }
  const std::string one = "out/s-shard-1-of-3 ", two = "out/s-shard-2-of-3 ", three = "out/s-shard-3-of-3 ";
  CHECK_FALSE(folder.has("out/s-shard-1-of-3/rocks.csv"));
  const Output merged = call(folder, "merge " + three + one + two + "-o merged --quiet");
  INFO(merged.err);
  CHECK(merged.code == 0);
  check_same(folder, "whole", "merged");

  const Output some = call(folder, "merge " + one + three + "-o some --quiet");
  CHECK(some.code == 3);
  CHECK(some.err.find("40 of 120 chunks are missing, from trial 1 of point 0 on") != std::string::npos);
  CHECK(call(folder, "merge " + one + two + one + "-o twice")
            .err.find("both hold p0-c0.chunk: a shard given twice") != std::string::npos);
  CHECK(call(folder, "run s.yaml --seed 9 --shard 2/3 --quiet -o foreign").code == 0);
  const Output foreign = call(folder, "merge " + one + "foreign -o f");
  CHECK(foreign.code == 2);
  CHECK(foreign.err.find("out/s-shard-1-of-3 and foreign are of different scenarios") != std::string::npos);
  CHECK(call(folder, "merge whole -o f")
            .err.find("whole has no chunks: it is not a shard but a finished result") != std::string::npos);
  CHECK(call(folder, "merge nowhere -o f").err.find("nowhere is not a result folder") != std::string::npos);
  CHECK(call(folder, "merge " + one + "-o " + one).err.find("needs a folder of its own") !=
        std::string::npos);
  CHECK_FALSE(folder.has("f"));

  fs::rename(folder.path() / "s.yaml", folder.path() / "moved.yaml");
  CHECK(call(folder, "merge " + one + "-o m").err.find("is not here; name it with --scenario FILE") !=
        std::string::npos);
  CHECK(call(folder, "merge " + one + two + three + "-o m --quiet --scenario moved.yaml").code == 0);
  check_same(folder, "whole", "m");
  CHECK(call(folder, "run moved.yaml --shard 4/3").err.find("--shard: `4/3`, expected i from 1 to n") !=
        std::string::npos);
}

TEST_CASE("With rows off the results are those of all rocks, and rows are those of the first", "[slow]") {
  const Folder folder;
  const std::string trials = std::to_string(flyrock::samples(300));
  const std::string run = std::string("run '") +
                          FLYROCK_SOURCE_DIR "/tests/unit/batch/mapped.yaml' --trials " + trials +
                          " --quiet ";
  const std::string off = run + "--set output.rocks=false --set output.first=20 ";
  REQUIRE(call(folder, run + "-o all").code == 0);
  REQUIRE(call(folder, off + "-o one -j 1").code == 0);
  REQUIRE(call(folder, off + "-o three -j 3").code == 0);
  for (const std::string shard : {"1", "2"})
    REQUIRE(call(folder, off + "--shard " + shard + "/2 -o shard" + shard).code == 0);
  REQUIRE(call(folder, "merge shard1 shard2 -o merged").code == 0);
  check_same(folder, "one", "three");
  check_same(folder, "one", "merged");
  const auto lines = [&](const std::string& file, const char* without) {
    std::istringstream text(read(folder.path() / file));
    std::vector<std::string> list;
    for (std::string line; std::getline(text, line);) {
      if (!line.empty() && line.back() == ',') line.pop_back();
      if (*without == 0 || line.find(without) == std::string::npos) list.push_back(line);
    }
    return list;
  };
  CHECK(lines("one/summary.json", "\"rows\"") == lines("all/summary.json", "\"rows\""));
  CHECK(read(folder.path() / "one/summary.json").find("\"rows\": \"20 of " + trials + "\"") !=
        std::string::npos);
  std::vector<std::string> first = lines("all/rocks.csv", "");
  first.resize(21);
  CHECK(lines("one/rocks.csv", "") == first);
  const auto rows = [&](const std::string& result, const std::string& sql) {
    return query(folder.path() / result / "results.db", sql);
  };
  for (const std::string table : {"inputs", "impacts", "trajectories"}) {
    CHECK(rows("one", "SELECT * FROM " + table + " ORDER BY trial") ==
          rows("all", "SELECT * FROM " + table + " WHERE trial < 20 ORDER BY trial"));
  }
  CHECK(rows("one", "SELECT max(trial) FROM inputs") == std::vector<std::string>{"19"});
  CHECK(rows("one", "SELECT * FROM maps") == rows("all", "SELECT * FROM maps"));
}
