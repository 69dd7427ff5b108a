#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

TEST_CASE("The answer says on which material round rocks roll when their time is up, on a slope too") {
  const Folder folder;
  std::string text = bench_with("[3, 0], [300, 0]", "[3, 0], [200, -10], [300, -12]");
  text.replace(text.find("{ type: polygon, sides: { integer: [5, 8] }, diameter: 0.5 }"), 60,
               "{ type: disk, radius: { uniform: [0.2, 0.4] } }");
  text.replace(text.find("    rolling: { type: rolling_resistance, mu_r: 0.1 m }\n"), 55, "");
  text.replace(text.find("time: 60 s"), 10, "time: 12 s");
  folder.write("balls.yaml", text);
  const Output run = call(folder, "run balls.yaml");
  INFO(run.out << run.err);
  CHECK(run.out.find("4 ran out of time (12 s) on rock, ") != std::string::npos);
}

TEST_CASE("A run writes its folder and says where the report is") {
  const Folder folder;
  const std::string name = folder.write("bench.yaml", bench);
  const Output run = call(folder, "run " + name);
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("A small bench\n") == 0);
  CHECK(run.out.find("report: out/bench/report.html") != std::string::npos);
  CHECK(run.out.find('\033') == std::string::npos);  // a pipe gets no colours,
  CHECK(run.err.find('\r') == std::string::npos);    // and no progress bar
  for (const char* file : {"manifest.json", "summary.json", "rocks.csv", "report.html", "run.log"})
    CHECK(folder.has(std::string("out/bench/") + file));
  CHECK_FALSE(folder.has("out/bench/chunks"));

  const std::string csv = read(folder.path() / "out/bench/rocks.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);
  const auto manifest = nlohmann::json::parse(read(folder.path() / "out/bench/manifest.json"));
  CHECK(manifest["seed"] == 3);
  CHECK(manifest["chunk_size"] == 1);
  CHECK(manifest["scenario"]["title"] == "A small bench");
  CHECK(manifest.dump().find(folder.path().string()) == std::string::npos);
}

TEST_CASE("Two runs give the same bytes, wherever they are written") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  REQUIRE(call(folder, "run bench.yaml -o a --quiet").code == 0);
  REQUIRE(call(folder, "run bench.yaml -o b/c --quiet").code == 0);
  for (const char* file : {"manifest.json", "summary.json", "rocks.csv", "report.html"})
    CHECK(read(folder.path() / "a" / file) == read(folder.path() / "b/c" / file));
  REQUIRE(call(folder, "run bench.yaml -o d --quiet --seed 4").code == 0);
  CHECK(read(folder.path() / "a/rocks.csv") != read(folder.path() / "d/rocks.csv"));
}

TEST_CASE("Trials are the same whatever runs beside them") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  REQUIRE(call(folder, "run bench.yaml -o all --quiet").code == 0);
  REQUIRE(call(folder, "run bench.yaml -o two --quiet --trials 2").code == 0);
  const std::string all = read(folder.path() / "all/rocks.csv");
  CHECK(all.starts_with(read(folder.path() / "two/rocks.csv")));
  const Output only = call(folder, "run bench.yaml --only point=0,trial=3");
  REQUIRE(only.code == 0);
  const std::string one = read(folder.path() / "out/bench-p0-t3/rocks.csv");
  const std::string row = one.substr(one.find('\n') + 1);
  CHECK(row.starts_with("0,3,0,blocks,"));
  CHECK(all.ends_with(row));
  CHECK(only.out.find("runout m") != std::string::npos);
}

TEST_CASE("A trial that is replayed has the rows and the trajectory that it had in the run") {
  const Folder folder;
  folder.write(
      "bench.yaml",
      bench_with("mu: 0.6", "mu: { sweep: [0.5, 0.7] }") +
          "gates: [{ name: road, x: 6 }]\nbarriers: [{ name: fence, x: 9, height: 3, capacity: 5 kJ }]\n");
  REQUIRE(call(folder, "run bench.yaml -o all --quiet").code == 0);
  REQUIRE(call(folder, "run bench.yaml -o one --quiet --only point=1,trial=2").code == 0);
  const fs::path all = folder.path() / "all/results.db", one = folder.path() / "one/results.db";
  for (const std::string table : {"rocks", "inputs", "impacts", "trajectories", "gates", "barriers"}) {
    INFO(table);
    const auto rows = query(one, "SELECT * FROM " + table);
    CHECK_FALSE(rows.empty());
    CHECK(rows == query(all, "SELECT * FROM " + table + " WHERE point = 1 AND trial = 2"));
  }
  // A trial whose trajectory the run did not store has the same rows, and its trajectory.
  folder.write("few.yaml",
               read(folder.path() / "bench.yaml") + "output: { trajectories: { first: 1, every: 20 ms } }\n");
  REQUIRE(call(folder, "run few.yaml -o few --quiet").code == 0);
  REQUIRE(call(folder, "run few.yaml -o again --quiet --only point=1,trial=2").code == 0);
  CHECK(query(folder.path() / "few/results.db", "SELECT * FROM trajectories WHERE trial = 2").empty());
  CHECK(query(folder.path() / "again/results.db", "SELECT * FROM trajectories") ==
        query(one, "SELECT * FROM trajectories"));
  CHECK(query(folder.path() / "again/results.db", "SELECT * FROM rocks") ==
        query(one, "SELECT * FROM rocks"));
}

TEST_CASE("Rocks that run out of time or leave the domain are rows, and no faults") {
  const Folder folder;
  folder.write("short.yaml", bench_with("time: 60 s", "time: 0.1 s"));
  folder.write("near.yaml", bench_with("[300, 0]", "[3.5, 0]"));
  const std::map<std::string, std::string> row_of{
      {"short", "timed_out|1|"}, {"near", "left_domain|1|it passed the end of the terrain towards +x"}};
  for (const auto& [name, row] : row_of) {
    const Output run = call(folder, "run " + name + ".yaml -o " + name + " --quiet --strict");
    INFO(run.err);
    CHECK(run.code == 0);
    CHECK(query(folder.path() / name / "results.db",
                "SELECT DISTINCT stop_reason, censored, fault FROM rocks") == std::vector<std::string>{row});
  }
}

TEST_CASE(
    "The first lines say on what rocks rolled when time was up, and how the landings of points are called") {
  const Folder folder;
  std::string rolling = bench_with("{ type: polygon, sides: { integer: [5, 8] }, diameter: 0.5 }",
                                   "{ type: disk, radius: 0.25 }");
  rolling.erase(rolling.find("    rolling:"), rolling.find("rocks:") - rolling.find("    rolling:"));
  folder.write("rolling.yaml", rolling.replace(rolling.find("time: 60 s"), 10, "time: 12 s"));
  const Output run = call(folder, "run rolling.yaml -o r");
  INFO(run.out);
  CHECK(run.code == 0);
  CHECK(run.out.find(" 100 % (95 % interval 39.8 to 100 %) of the rocks are censored: 4 ran out of time (12 "
                     "s) on rock, x from ") != std::string::npos);
  const auto summary = nlohmann::json::parse(read(folder.path() / "r/summary.json"));
  CHECK(summary["points"][0]["censored"][0]["material"] == "rock");
  folder.write("flight.yaml", bench_with("method: nscd", "method: ballistic"));
  const Output flight = call(folder, "run flight.yaml -o f");
  INFO(flight.out);
  CHECK(flight.out.find("The distance of the first landing that 95 % of the rocks do not exceed is ") !=
        std::string::npos);
  CHECK(flight.out.find("  first landing, m") != std::string::npos);
  CHECK(flight.out.find("  4 first landed\n") != std::string::npos);
}

TEST_CASE("A clearance per blast of few rocks is warned of, and says with how many") {
  const Folder folder;
  folder.write("s.yaml", bench_with("trials: 4", "trials: 40") +
                             "clearance: [{ name: road, group: blocks, probability: 0.5, per: blast }]\n");
  const Output check = call(folder, "check s.yaml");
  CHECK(check.code == 0);
  CHECK(
      check.err.find(
          "warning: clearance.0.per: each simulated blast has only 1 rock. A real blast throws thousands") !=
      std::string::npos);
  const Output run = call(folder, "run s.yaml -o r");
  CHECK(run.code == 0);
  CHECK(run.out.find("One blast in 2 throws a rock of blocks beyond ") != std::string::npos);
  CHECK(run.out.find("  road: a rock of blocks beyond ") != std::string::npos);
  CHECK(run.out.find("A blast has 1 rock of blocks.") != std::string::npos);
}

TEST_CASE("An existing folder is replaced with --force only, and other files in it stay") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  REQUIRE(call(folder, "run bench.yaml -o r --quiet --trials 1").code == 0);
  folder.write("r/mine.txt", "mine");
  const std::string before = read(folder.path() / "r/rocks.csv");
  const Output again = call(folder, "run bench.yaml -o r");
  CHECK(again.code == 2);
  CHECK(again.err.find("r exists; --resume goes on with an unfinished run, --force replaces the results in "
                       "it, -o DIR names another folder") != std::string::npos);
  CHECK(read(folder.path() / "r/rocks.csv") == before);
  REQUIRE(call(folder, "run bench.yaml -o r --quiet --force").code == 0);
  CHECK(read(folder.path() / "r/rocks.csv") != before);
  CHECK(read(folder.path() / "r/mine.txt") == "mine");
}

TEST_CASE("Expectations set the exit code") {
  const Folder folder;
  folder.write("good.yaml", std::string(bench) + "expect:\n  - { measure: rocks.count, equals: 4 }\n");
  CHECK(call(folder, "run good.yaml").code == 0);
  folder.write("bad.yaml", std::string(bench) + "expect:\n  - { measure: rocks.runout.p95, below: 1 m }\n");
  const Output bad = call(folder, "run bad.yaml");
  CHECK(bad.code == 1);
  CHECK(bad.out.find("0 of 1 expectations hold") != std::string::npos);
  const Output few = call(folder, "run bad.yaml -o few --trials 2");
  CHECK(few.code == 0);
  CHECK(few.out.find("not judged") != std::string::npos);
}

TEST_CASE("Bad input: exit code 2, the reason on stderr, nothing written") {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& reason) {
    folder.write("bad.yaml", text);
    const Output run = call(folder, "run bad.yaml");
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find(reason) != std::string::npos);
    CHECK_FALSE(folder.has("out"));
  };
  refused(bench_with("density: 2700", "densty: 2700"),
          "bad.yaml:15:5: error: rocks.0.densty: unknown key, did you mean `density`?");
  refused(bench_with("en: 0.3", "en: -0.3"),
          "bad.yaml:10:38: error: materials.rock.restitution.en: is `-0.3`, must be at least 0");
  refused(std::string(bench) + "expect:\n  - { measure: rocks.runnout.p95, below: 1 m }\n",
          "did you mean `runout`?");
  refused("", "bad.yaml");
  refused(bench_with("seed: 3", "seed: [3"), "bad.yaml");

  CHECK(call(folder, "run nowhere.yaml").err.find("nowhere.yaml") != std::string::npos);
  CHECK(call(folder, "run nowhere.yaml").code == 2);
  CHECK(call(folder, "run nowhere.txt").err.find("expected a scenario: a file .yaml, .yml or .lua") !=
        std::string::npos);
}

TEST_CASE("A law that fails later is a row, and exit code 3") {
  const Folder folder;
  folder.write("tired.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "tired", form = "newton",
  doc = "Fails at the second impact.", source = "a test",
  params = {},
  impact = function(p, contact)
    if contact.impact_number > 1 then error("too tired") end
    return 0.5, 0
  end,
}
)");
  folder.write("bench.yaml",
               "plugins: [tired.lua]\n" + bench_with("{ type: newton, en: 0.3 }", "{ type: tired }"));
  const Output run = call(folder, "run bench.yaml -o r");
  INFO(run.err);
  CHECK(run.code == 3);
  CHECK(run.err.find("plugin_error") != std::string::npos);
  CHECK(run.err.find("tired.lua:7") != std::string::npos);
  CHECK(read(folder.path() / "r/rocks.csv").find("plugin_error") != std::string::npos);
  CHECK(folder.has("r/report.html"));
  const Output strict = call(folder, "run bench.yaml -o s --strict");
  CHECK(strict.code == 3);
  CHECK(strict.err.find("the run ended early") != std::string::npos);
}

TEST_CASE("A law that prints at each impact shows a few lines, the same for any number of threads") {
  const Folder folder;
  folder.write("chatty.lua", R"(local fr = require "flyrock"
print("loading")
return fr.plugin {
  kind = "restitution", name = "chatty", doc = "d",
  params = { en = fr.number { default = 0.3, min = 0, doc = "d" } },
  impact = function(p, contact)
    print("speed", contact.approach_speed, "\27[2J")
    return p.en
  end,
}
)");
  folder.write("bench.yaml",
               "plugins: [chatty.lua]\n" + bench_with("{ type: newton, en: 0.3 }", "{ type: chatty }"));
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const std::string one = call(folder, "run bench.yaml --trials 60 --quiet -o one -j 1").err;
  INFO(one);
  CHECK(one.find("loading\nspeed\t0.1\t\\x1B[2J\nspeed\t3.0\t") == 0);
  CHECK(lines(one) == 1 + 3 + 11);  // while it loads, on sampled states, in the trials
  CHECK(one.find("chatty.lua:7: print: after 10 lines the others of this place are dropped\n") !=
        std::string::npos);
  CHECK(call(folder, "run bench.yaml --trials 60 --quiet -o three -j 3").err == one);
  CHECK(lines(call(folder, "check chatty.lua").err) == 1 + 11);
}

TEST_CASE("An interrupt ends with 130 and keeps what was done") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  const Output run = call_and_interrupt(folder, "bench.yaml", "out/bench/chunks/p0-c0.chunk");
  INFO(run.err);
  CHECK(run.code == 130);
  CHECK(run.err.find("interrupted after ") == 0);
  CHECK(folder.has("out/bench/chunks/p0-c0.chunk"));
  CHECK_FALSE(folder.has("out/bench/rocks.csv"));
}

TEST_CASE("The Lua twin of a scenario gives the same bytes") {
  const Folder folder;
  const std::string scenarios = FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d";
  for (const char* language : {"yaml", "lua"}) {
    const Output run =
        call(folder, "run '" + scenarios + "." + language + "' --trials 10 --quiet -o " + language);
    INFO(run.err);
    CHECK(run.code == 0);
  }
  for (const char* file : {"rocks.csv", "summary.json"}) {
    CHECK_FALSE(read(folder.path() / "lua" / file).empty());
    CHECK(read(folder.path() / "lua" / file) == read(folder.path() / "yaml" / file));
  }
}
