// Hostile plugins: each case of tests/scenarios/hostile is used as a law. Its messages are what `flyrock run`
// says, after its exit code; where only the rocks of the group `hostile` suffer, the others are as with a
// sound law.

#include <catch2/catch.hpp>
#include <chrono>
#include <sstream>
#include <vector>

#include "cli/program.h"
#include "scenarios/cases.h"

using namespace flyrock::test;

namespace hostile_test {

namespace {

const fs::path folder_of_laws = fs::path(FLYROCK_SOURCE_DIR) / "tests/scenarios/hostile";

std::string scenario(const std::string& law) {
  const std::string type = law.empty() ? "newton, en: 0.3" : "hostile";
  return "flyrock: 1\ndimension: 2\nmethod: nscd\nseed: 3\ntrials: 2\nplugins: [" + law + R"(]
terrain: { type: profile, points: [[-20, 10], [0, 10], [3, 0], [300, 0]], material: ground }
materials:
  ground: { restitution: { type: )" +
         type + R"( }, friction: { type: coulomb, mu: 0.6 } }
rocks:
  - name: sound
    density: 2700
    shape: { type: polygon, sides: 6, diameter: 0.5 }
    release: { position: [0, 12] }
    launch: { type: fixed, speed: { uniform: [5, 15] }, elevation: 20 deg }
  - name: hostile
    density: 2700
    shape: { type: polygon, sides: 6, diameter: 0.5 }
    release: { position: [0, 14] }
    launch: { type: fixed, speed: { uniform: [5, 15] }, elevation: 20 deg }
stop: { time: 60 s }
)";
}

/// The rows of rocks.csv whose group is `sound`.
std::vector<std::string> sound_rows(const Folder& folder) {
  std::istringstream table(read(folder.path() / "out/rocks.csv"));
  std::vector<std::string> rows;
  for (std::string row; std::getline(table, row);)
    if (row.find(",sound,") != std::string::npos) rows.push_back(row);
  return rows;
}

Output run_with(const Folder& folder, const std::string& law) {
  folder.write("quarry.yaml", scenario(law));
  return call(folder, "run quarry.yaml -o out --force --quiet");
}

}  // namespace

TEST_CASE("hostile plugins are contained, each with its exact text", "[slow]") {
  const Folder folder;
  fs::copy(folder_of_laws, folder.path(), fs::copy_options::recursive);
  REQUIRE(run_with(folder, "").code == 0);
  const std::vector<std::string> undisturbed = sound_rows(folder);
  REQUIRE(undisturbed.size() == 2);

  std::size_t count = 0;
  const auto check = [&](const std::string& law, std::string& says) {
    INFO(law);
    ++count;
    const auto start = std::chrono::steady_clock::now();
    const Output output = run_with(folder, law);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    // Calls of a law end after 0.5 s of the processor at most; sanitizers and a busy machine take longer.
    CHECK(spent.count() < 30);
    const std::string said = "exit " + std::to_string(output.code) + "\n" + output.err;
    if (updates()) says = said;
    CHECK(said == says);
    if (output.code == 3) CHECK(sound_rows(folder) == undisturbed);
  };
  for (const char* name : {"first", "load", "run"}) {
    const fs::path path = folder_of_laws / (std::string(name) + ".cases");
    CaseFile file = read_cases(path);
    for (MessageCase& one : file.cases) {
      folder.write(one.name, one.input);
      check(one.name, one.says);
    }
    if (updates()) write_cases(path, file);
  }
  std::string binary = read(folder_of_laws / "load_binary.expect");  // its law is no text
  check("load_binary.lua", binary);
  REQUIRE(count >= 90);
}

TEST_CASE("a law that fails for every rock ends the run early, and at once with --strict") {
  const Folder folder;
  folder.write("tired.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "hostile", doc = "fails in every run", impact = function(p, contact)
  if contact.time > 0 then error("tired") end
  return 0.3
end })");
  folder.write("quarry.yaml", scenario("tired.lua"));
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  const Output run = call(folder, "run quarry.yaml -o all --quiet --trials 1000");
  INFO(run.err);
  CHECK(run.code == 3);
  CHECK(run.err.find("the run ended early") != std::string::npos);
  CHECK(count(read(folder.path() / "all/rocks.csv"), "plugin_error") == 20);
  const Output strict = call(folder, "run quarry.yaml -o strict --quiet --strict");
  INFO(strict.err);
  CHECK(strict.code == 3);
  CHECK(count(read(folder.path() / "strict/rocks.csv"), "plugin_error") ==
        2);  // the rocks of the first trial
  CHECK(count(strict.err, "tired.lua:3: tired") >= 1);
}

}  // namespace hostile_test
