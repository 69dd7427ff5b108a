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
#include "files/sha256.h"
#include "long_scenarios.h"

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

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(scenarios)) {
    const std::string extension = entry.path().extension();
    if (extension == ".yaml" || extension == ".lua") names.push_back(fs::relative(entry.path(), scenarios));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The scenarios of a folder without those of long trials.
std::vector<std::string> quick_ones_of(const std::string& folder) {
  std::vector<std::string> names = shipped();
  std::erase_if(names, [&](const std::string& name) {
    return !name.starts_with(folder + '/') || flyrock::long_trials.contains(name);
  });
  return names;
}

/// Runs three trials of a scenario, or one long one, and adds the hashes of its results.
void run(const Folder& folder, const std::string& scenario, const std::string& threads,
         std::map<std::string, std::string>& hashes) {
  const std::string trials = flyrock::long_trials.contains(scenario) ? "1" : "3";
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

/// Puts hashes in the place of those that hashes.txt has of these scenarios, and leaves out what is no longer
/// shipped.
void update(std::map<std::string, std::string> hashes) {
  const std::vector<std::string> names = shipped();
  for (const auto& [name, hash] : known_hashes())
    if (std::binary_search(names.begin(), names.end(), name.substr(0, name.find(' '))))
      hashes.emplace(name, hash);
  std::ofstream file(golden);
  for (const auto& [name, hash] : hashes) file << name << ' ' << hash << '\n';
}

void golden_bytes_of(const std::vector<std::string>& names) {
  const Folder folder;
  const std::vector<std::string> threads = thread_numbers();
  std::map<std::string, std::string> hashes;
  for (std::size_t i = 0; i < names.size(); ++i) run(folder, names[i], threads[i % threads.size()], hashes);
  if (std::getenv("FLYROCK_UPDATE_GOLDEN")) update(hashes);
  compare(hashes);
}

}  // namespace

// A folder is a test of its own, so that CTest runs them side by side.
TEST_CASE("The scenarios of the course give the golden bytes") { golden_bytes_of(quick_ones_of("course")); }
TEST_CASE("The scenarios of Ninh Dan give the golden bytes") { golden_bytes_of(quick_ones_of("ninh_dan")); }
TEST_CASE("The scenarios of quarries give the golden bytes") { golden_bytes_of(quick_ones_of("quarry")); }
TEST_CASE("The scenarios of rockfall give the golden bytes") { golden_bytes_of(quick_ones_of("rockfall")); }
TEST_CASE("The scenarios of many bodies or nodes give the golden bytes", "[slow]") {
  golden_bytes_of({flyrock::long_trials.begin(), flyrock::long_trials.end()});
}

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
