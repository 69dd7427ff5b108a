// Malformed scenarios: each case of tests/scenarios/bad gives exactly its messages, when it is read or when
// its first trials are made.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "batch/runners.h"
#include "files/safe_file.h"
#include "load/try_points.h"
#include "scenarios/cases.h"
#include "temporary_file.h"

namespace fs = std::filesystem;

namespace {

using flyrock::test::updates;

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
  if (loaded) flyrock::try_runners(*loaded, flyrock::tried_trials, diagnostics);
  return diagnostics;
}

/// The messages about a scenario are the text of its .expect.
void check_text(const flyrock::Diagnostics& diagnostics, const fs::path& path) {
  const fs::path expect = fs::path(path).replace_extension(".expect");
  if (updates()) std::ofstream(expect) << diagnostics.to_text();
  CHECK(diagnostics.to_text() == flyrock::read_file(expect));
}

fs::path folder_of(const std::string& name) {
  return fs::path(FLYROCK_SOURCE_DIR) / "tests/scenarios" / name;
}

/// Every case of the files .cases of a folder. Returns how many there are.
int check_cases(const std::string& name) {
  const fs::path scratch =
      fs::temp_directory_path() / ("flyrock_cases_" + name + "_" + std::to_string(::getpid()));
  fs::create_directories(scratch);
  fs::copy(folder_of(name), scratch, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  int count = 0;
  for (const fs::path& path : files(folder_of(name), ".cases")) {
    const InFolder inside(scratch);
    flyrock::test::CaseFile file = flyrock::test::read_cases(path);
    for (flyrock::test::MessageCase& one : file.cases) {
      INFO(path.filename() << ", " << one.name);
      std::ofstream(scratch / one.name) << one.input;
      const flyrock::Diagnostics diagnostics = messages_about(one.name);
      CHECK(diagnostics.has_errors());
      if (updates()) one.says = diagnostics.to_text();
      CHECK(diagnostics.to_text() == one.says);
      ++count;
    }
    if (updates()) write_cases(path, file);
  }
  fs::remove_all(scratch);
  return count;
}

/// Scenarios whose bytes are what is wrong with them: each stands in a file of its own, beside its .expect.
int check_files(const std::string& name) {
  const InFolder inside(folder_of(name));
  int count = 0;
  for (const fs::path& path : files(folder_of(name), ".yaml")) {
    INFO(path.filename());
    const flyrock::Diagnostics diagnostics = messages_about(path);
    CHECK(diagnostics.has_errors());
    check_text(diagnostics, path);
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("malformed scenarios give their exact error texts") {
  CHECK(check_cases("bad") >= 80);
  CHECK(check_files("bad") >= 4);
}
TEST_CASE("malformed scenarios in Lua give their exact error texts", "[slow]") {
  CHECK(check_cases("bad_lua") >= 14);
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
      const TemporaryFile copy("resolved.yaml", resolved);
      const auto again = flyrock::load_scenario(copy.path, {}, diagnostics);
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
