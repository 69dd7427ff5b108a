// The shipped scenarios give the bytes of hashes.txt, by every build and over any number of threads.
//
//   FLYROCK_GOLDEN_THREADS="1 2 3"   the numbers of threads, in turn (this is the default)
//   FLYROCK_UPDATE_GOLDEN=1          writes hashes.txt anew: make golden

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>

#include "../cli/program.h"
#include "batch/sha256.h"

using namespace flyrock::test;

namespace {

const fs::path golden = FLYROCK_SOURCE_DIR "/tests/golden/hashes.txt";
const fs::path scenarios = FLYROCK_SOURCE_DIR "/scenarios";

/// The lines "SCENARIO FILE HASH" by their first two words.
std::map<std::string, std::string> known_hashes() {
  std::map<std::string, std::string> hashes;
  std::istringstream lines(read(golden));
  for (std::string scenario, file, hash; lines >> scenario >> file >> hash;)
    hashes[scenario + ' ' + file] = hash;
  return hashes;
}

/// The scenarios of a folder of scenarios/, or of all.
std::vector<std::string> shipped(const std::string& folder = "") {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(scenarios / folder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".yaml" || extension == ".lua") names.push_back(fs::relative(entry.path(), scenarios));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A trial of many bodies takes as long as many other scenarios together; one of them is run.
const std::set<std::string> long_trials{"course/column_collapse.lua", "course/drum.lua",
                                        "quarry/bench_failure_2d.yaml", "quarry/joint_blocks_3d.yaml",
                                        "quarry/muck_pile.lua"};

/// Runs three trials of a scenario, and adds the hashes of its results.
void run(const Folder& folder, const std::string& scenario, const std::string& threads,
         std::map<std::string, std::string>& hashes) {
  const std::string trials = long_trials.contains(scenario) ? "1" : "3";
  const Output run = call(folder, "run '" + (scenarios / scenario).string() + "' --trials " + trials +
                                      " --quiet --force -o out -j " + threads);
  INFO(scenario << " over " << threads << " threads: " << run.err);
  REQUIRE((run.code == 0 || run.code == 1));  // 1: an expectation is not met by so few
  for (const char* file : {"rocks.csv", "summary.json"})
    hashes[scenario + ' ' + file] = flyrock::sha256(read(folder.path() / "out" / file)).substr(0, 16);
}

std::vector<std::string> thread_numbers() {
  const char* asked = std::getenv("FLYROCK_GOLDEN_THREADS");
  std::istringstream words(asked ? asked : "1 2 3");
  return {std::istream_iterator<std::string>(words), {}};
}

void compare(const std::map<std::string, std::string>& hashes) {
  const std::map<std::string, std::string> known = known_hashes();
  for (const auto& [name, hash] : hashes) {
    INFO(name << ": other bytes than those of tests/golden/hashes.txt. If you meant to change them, run "
                 "`make golden` and say why "
                 "under \"Numerics changed\" in CHANGELOG.md. If not, find the change: git bisect");
    CHECK((known.contains(name) ? known.at(name) : "none") == hash);
  }
}

/// Puts the hashes of a folder in the place of those that hashes.txt has of it.
void update(const std::string& folder, std::map<std::string, std::string> hashes) {
  for (const auto& [name, hash] : known_hashes())
    if (!name.starts_with(folder + '/')) hashes.emplace(name, hash);
  std::ofstream file(golden);
  for (const auto& [name, hash] : hashes) file << name << ' ' << hash << '\n';
}

/// A folder is a test of its own, so that CTest runs them side by side.
void golden_bytes_of(const std::string& scenario_folder) {
  const Folder folder;
  const std::vector<std::string> names = shipped(scenario_folder), threads = thread_numbers();
  std::map<std::string, std::string> hashes;
  for (std::size_t i = 0; i < names.size(); ++i) run(folder, names[i], threads[i % threads.size()], hashes);
  if (std::getenv("FLYROCK_UPDATE_GOLDEN")) update(scenario_folder, hashes);
  compare(hashes);
}

}  // namespace

TEST_CASE("The scenarios of the course give the golden bytes") { golden_bytes_of("course"); }
TEST_CASE("The scenarios of Ninh Dan give the golden bytes") { golden_bytes_of("ninh_dan"); }
TEST_CASE("The scenarios of quarries give the golden bytes") { golden_bytes_of("quarry"); }
TEST_CASE("The scenarios of rockfall give the golden bytes") { golden_bytes_of("rockfall"); }

TEST_CASE("hashes.txt knows the shipped scenarios and no others: if not, run `make golden`") {
  std::set<std::string> known, files;
  for (const auto& [name, hash] : known_hashes()) known.insert(name.substr(0, name.find(' ')));
  for (const std::string& name : shipped()) {
    files.insert(name);
    INFO("a folder of scenarios without its test of golden bytes: " << name);
    CHECK(std::set<std::string>{"course", "ninh_dan", "quarry", "rockfall"}.contains(
        name.substr(0, name.find('/'))));
  }
  CHECK(known == files);
}

TEST_CASE("Each shipped scenario gives the golden bytes over the other numbers of threads too", "[heavy]") {
  const Folder folder;
  const std::vector<std::string> names = shipped(), threads = thread_numbers();
  for (std::size_t others = 1; others < threads.size(); ++others) {
    std::map<std::string, std::string> hashes;
    for (std::size_t i = 0; i < names.size(); ++i)
      run(folder, names[i], threads[(i + others) % threads.size()], hashes);
    compare(hashes);
  }
}
