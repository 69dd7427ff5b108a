// Every YAML block of docs/scenario.md is accepted in a scenario, as a reader would put it there.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "batch/runners.h"
#include "document/yaml_reader.h"

namespace fs = std::filesystem;

namespace flyrock::page_blocks_test {

namespace {

/// Scenarios that have all names that the blocks use.
const char* const frames[] = {
    // rocks in 2D
    R"(flyrock: 1
dimension: 2
method: nscd
trials: 2000
terrain: { type: profile, points: [[-20, 10], [0, 10], [3, 0], [300, 0]], material: limestone }
materials:
  limestone: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.6 } }
  gravel: { restitution: { type: newton, en: 0.2 }, friction: { type: coulomb, mu: 0.8 } }
rocks:
  - name: loose
    density: 2700
    shape: { type: polygon, sides: 6, diameter: 0.5 }
    release: { position: [0, 12] }
    launch: { type: fixed, speed: 5 m/s, elevation: 20 deg }
stop: { time: 60 s }
)",
    // bodies in 2D, with a sweep
    R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: plane, material: floor }
materials:
  floor: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: { sweep: [0.1, 0.2] } }, rolling: { type: rolling_resistance, mu_r: 1 mm } }
bodies:
  - { name: ball, shape: { type: disk, radius: 0.1 }, mass: 1, position: [0, 1] }
  - { name: disk, shape: { type: disk, radius: 0.1 }, mass: 1, position: [1, 1] }
body_contacts: off
stop: { time: 5 s }
)",
    // rocks in 3D
    R"(flyrock: 1
dimension: 3
method: nscd
terrain:
  type: plane
  material: rock
  zones: [{ name: wood, polygon: [[20, -20], [60, -20], [60, 20], [20, 20]] }]
materials:
  rock: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.6 } }
rocks:
  - name: loose
    density: 2700
    shape: { type: box, size: [0.6, 0.5, 0.4] }
    release: { position: [0, 0, 2] }
    launch: { type: fixed, speed: 5 m/s, elevation: 20 deg }
stop: { time: 60 s }
)",
    // points that fly, in 3D
    R"(flyrock: 1
dimension: 3
method: ballistic
terrain: { type: plane }
materials:
  rock: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.6 } }
rocks:
  - name: thrown
    density: 2700
    shape: { type: sphere, radius: 0.1 }
    release: { position: [0, 0, 2] }
    launch: { type: fixed, speed: 40 m/s, elevation: 45 deg }
stop: { time: 60 s }
)",
};

const char* const trees = "x,y,dbh_cm,height_m,species\n20,3,40,25,fir\n25,-4,55,28,beech\n";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> yaml_blocks(const std::string& page) {
  const std::string open = "```yaml\n";
  std::vector<std::string> blocks;
  for (auto at = page.find(open); at != page.npos; at = page.find(open, at)) {
    at += open.size();
    blocks.push_back(page.substr(at, page.find("```", at) - at));
  }
  return blocks;
}

bool is_whole(const std::string& block) { return block.find("flyrock: 1") != std::string::npos; }

/// A block that shows the same key several times, or a list of expectations on different scenarios, has
/// several examples.
std::vector<std::string> examples_in(const std::string& block) {
  if (is_whole(block)) return {block};
  std::istringstream lines(block);
  std::vector<std::string> examples;
  std::string key;
  for (std::string line; std::getline(lines, line);) {
    const bool is_key = !line.empty() && line[0] != ' ' && line[0] != '#';
    const std::string name = is_key ? line.substr(0, line.find(':')) : key;
    const bool is_next = is_key ? name == key : key == "expect" && examples.back() != "expect:\n";
    if (examples.empty() || is_next) examples.emplace_back();
    if (is_next && !is_key) examples.back() = "expect:\n";
    key = name;
    examples.back() += line + '\n';
  }
  return examples;
}

/// Puts an example into a frame: its sections replace those of the frame, its materials stand beside them.
void put_into(Value& frame, const Value& example) {
  for (const Entry& entry : *example.map()) {
    Value* place = frame.find(entry.key);
    if (entry.key == "restitution") {
      *frame.find("materials")->map()->front().value.find("restitution") = entry.value;
    } else if (place && entry.key == "materials") {
      for (const Entry& material : *entry.value.map()) place->map()->push_back(material);
    } else if (place) {
      *place = entry.value;
    } else {
      frame.map()->push_back(entry);
    }
  }
}

Value read(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<Value> value = read_yaml(text, "page.yaml", diagnostics);
  INFO(text << diagnostics.to_text());
  REQUIRE(value);
  return *value;
}

/// The messages about a scenario in `folder`, as `flyrock check` gives them.
std::string errors_of(const fs::path& folder, const std::string& scenario) {
  const fs::path path = folder / "page.yaml";
  std::ofstream(path) << scenario;
  Diagnostics diagnostics;
  std::optional<LoadedScenario> loaded = load_scenario(path.string(), {}, diagnostics);
  if (loaded) try_runners(*loaded, 3, diagnostics);
  return diagnostics.has_errors() ? diagnostics.to_text() : std::string();
}

}  // namespace

TEST_CASE("every YAML block of docs/scenario.md is accepted in a scenario") {
  const fs::path folder = fs::temp_directory_path() / ("flyrock_page_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "trees.csv") << trees;
  std::ofstream(folder / "blocks.csv") << "block,weight_t,l1,l2,l3\na,0.5,0.8,0.6,0.5\nb,0.7,0.9,0.7,0.5\n";
  std::ofstream(folder / "stops.csv") << "east_m,north_m\n30,1\n35,-2\n";
  int count = 0;
  for (const std::string& block : yaml_blocks(text_of(FLYROCK_SOURCE_DIR "/docs/scenario.md")))
    for (const std::string& example : examples_in(block)) {
      ++count;
      std::string messages;
      bool accepted = false;
      for (const char* frame : frames) {
        Value scenario = read(frame);
        put_into(scenario, read(example));
        const std::string errors = errors_of(folder, is_whole(example) ? example : to_yaml(scenario));
        accepted = accepted || errors.empty();
        messages += errors;
      }
      INFO(example << messages);
      CHECK(accepted);
    }
  CHECK(count >= 15);
  fs::remove_all(folder);
}

}  // namespace flyrock::page_blocks_test
