// Malformed scenarios: each file of tests/scenarios/bad gives exactly the text of its .expect, when it is
// read or when its first trials are made.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "batch/runners.h"

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Scenarios are named as they are from their folder, so that the texts hold no folder of a machine.
struct InFolder {
  fs::path before = fs::current_path();
  explicit InFolder(const fs::path& folder) { fs::current_path(folder); }
  ~InFolder() { fs::current_path(before); }
};

std::vector<fs::path> files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

/// A scenario as `flyrock check` reads it and tries it out.
flyrock::Diagnostics messages_about(const fs::path& path) {
  flyrock::Diagnostics diagnostics;
  auto loaded = flyrock::load_scenario(path.filename().string(), {}, diagnostics);
  if (loaded) flyrock::try_runners(*loaded, 200, diagnostics);
  return diagnostics;
}

/// The messages about a scenario are the text of its .expect.
void check_text(const flyrock::Diagnostics& diagnostics, const fs::path& path) {
  const fs::path expect = fs::path(path).replace_extension(".expect");
  // FLYROCK_UPDATE_EXPECT=1 writes the texts anew; look at the difference before it is committed.
  if (std::getenv("FLYROCK_UPDATE_EXPECT")) std::ofstream(expect) << diagnostics.to_text();
  CHECK(diagnostics.to_text() == read(expect));
}

fs::path folder_of(const std::string& name) {
  return fs::path(FLYROCK_SOURCE_DIR) / "tests/scenarios" / name;
}

/// Every file with this extension in a folder beside this one gives the text of its .expect.
void check_messages(const std::string& name, const std::string& extension, std::size_t at_least) {
  const fs::path folder = folder_of(name);
  const InFolder inside(folder);
  const std::vector<fs::path> scenarios = files(folder, extension);
  REQUIRE(scenarios.size() >= at_least);
  for (const fs::path& path : scenarios) {
    INFO(path.filename());
    const flyrock::Diagnostics diagnostics = messages_about(path);
    CHECK(diagnostics.has_errors());
    check_text(diagnostics, path);
  }
}

}  // namespace

TEST_CASE("malformed scenarios give their exact error texts") { check_messages("bad", ".yaml", 20); }
TEST_CASE("malformed scenarios in Lua give their exact error texts", "[slow]") {
  check_messages("bad_lua", ".lua", 12);
}

TEST_CASE("shipped scenarios load, and what they resolve to loads as the same plan") {
  for (const char* folder : {"scenarios/course", "scenarios/ninh_dan"}) {
    const fs::path path = fs::path(FLYROCK_SOURCE_DIR) / folder;
    for (const fs::path& scenario : files(path, ".yaml")) {
      INFO(scenario);
      flyrock::Diagnostics diagnostics;
      const auto loaded = flyrock::load_scenario(scenario.string(), {}, diagnostics);
      INFO(diagnostics.to_text());
      REQUIRE(loaded);
      const std::string resolved = to_yaml(loaded->plan.resolved);
      const fs::path copy = fs::temp_directory_path() / "flyrock_resolved.yaml";
      std::ofstream(copy) << resolved;
      const auto again = flyrock::load_scenario(copy.string(), {}, diagnostics);
      INFO(resolved << diagnostics.to_text());
      REQUIRE(again);
      CHECK(to_yaml(again->plan.resolved) == resolved);
    }
  }
}

TEST_CASE("the Lua twin of a scenario resolves to the same bytes") {
  const std::string stem = FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d";
  flyrock::Diagnostics diagnostics;
  const auto yaml = flyrock::load_scenario(stem + ".yaml", {}, diagnostics);
  const auto lua = flyrock::load_scenario(stem + ".lua", {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(yaml);
  REQUIRE(lua);
  CHECK(to_json(lua->plan.resolved) == to_json(yaml->plan.resolved));
  CHECK(lua->plan.not_used == yaml->plan.not_used);
}

TEST_CASE("values outside of what is usual are warned of, and refused under --strict") {
  const fs::path folder = folder_of("unusual");
  const InFolder inside(folder);
  flyrock::Diagnostics diagnostics = messages_about(folder / "quarry.yaml");
  CHECK_FALSE(diagnostics.has_errors());
  CHECK(diagnostics.warnings().size() >= 15);
  check_text(diagnostics, folder / "quarry.yaml");
  diagnostics.be_strict();
  CHECK(diagnostics.has_errors());
}
