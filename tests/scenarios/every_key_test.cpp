// Every key of a scenario with values that do not belong there. Each is refused at its place, or taken; none
// ends the program. The scenarios of tests/scenarios/every_key hold all keys of the schema.

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "batch/runners.h"
#include "document/yaml_reader.h"
#include "results/measured/clearance.h"
#include "scenario/decode.h"
#include "scenario/schema.h"

namespace fs = std::filesystem;
using namespace flyrock;

namespace {

const std::vector<std::string> bad_values{
    // of another kind
    "oops", "'12'", "''", "~", "true", "[]", "[oops, 1]", "[1, 2]", "[1, 2, 3, 4]", "[[oops, 0], [10, 0]]",
    "{ a: 1 }", "{ type: oops }", "../../x",
    // out of range
    "0", "-1", "2.5", "7", "1e-308", "5e-324", "1e300", "-1e300", "1e18", ".nan", ".inf", "-.inf",
    // units
    "12 parsec", "3 kg s", "-20 deg", "2 mm", "1e200 km",
    // sweeps and distributions
    "{ sweep: [1, 2] }", "{ sweep: [] }", "{ sweep: [oops, 1] }",
    "{ sweep: { from: 0, to: 1e300, count: 2 } }", "{ uniform: [1, 2] }", "{ uniform: [2, 1] }",
    "{ uniform: [oops, 1], per: never }", "{ normal: { mean: 1, sd: 1e300 } }", "{ discrete: [1e300, 0] }"};

Value read_value(const std::string& text, const std::string& name = "value.yaml") {
  Diagnostics diagnostics;
  std::optional<Value> value = read_yaml(text, name, diagnostics);
  INFO(text << diagnostics.to_text());
  REQUIRE(value);
  return *value;
}

/// A bad value as a tree. No file, but Lua, gives numbers that are not finite.
Value bad_value(const std::string& text) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const auto& [name, number] :
       {std::pair(".nan", std::nan("")), std::pair(".inf", infinite), std::pair("-.inf", -infinite)})
    if (text == name) return Value{number, {}};
  return read_value("v: " + text).map()->front().value;
}

const std::string folder = FLYROCK_SOURCE_DIR "/tests/scenarios/every_key";

std::vector<std::pair<std::string, Value>> documents() {
  std::vector<std::pair<std::string, Value>> list;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;  // what the scenarios name
    std::ifstream file(entry.path());
    const std::string name = entry.path().filename().string();
    list.emplace_back(name, read_value({std::istreambuf_iterator<char>(file), {}}, name));
  }
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return list;
}

/// A value of a tree and its path.
struct Slot {
  Value* value;
  std::string path;
};

/// All values below the root: of keys, and elements of lists.
void collect(Value& value, const std::string& path, std::vector<Slot>& slots) {
  if (!path.empty()) slots.push_back({&value, path});
  const std::string stem = path.empty() ? "" : path + ".";
  if (Map* map = value.map())
    for (Entry& entry : *map) collect(entry.value, stem + entry.key, slots);
  if (List* list = value.list())
    for (std::size_t i = 0; i < list->size(); ++i) collect((*list)[i], stem + std::to_string(i), slots);
}

std::vector<Slot> slots_of(Value& root) {
  std::vector<Slot> slots;
  collect(root, "", slots);
  return slots;
}

/// As if it had been read where it is put.
void relocate(Value& value, const Location& at) {
  value.at = at;
  if (List* list = value.list())
    for (Value& item : *list) relocate(item, at);
  if (Map* map = value.map())
    for (Entry& entry : *map) entry.at = at, relocate(entry.value, at);
}

/// Decodes a tree, and where it is sound makes a few of its trials, as `flyrock check` does. The errors that
/// do not say where they are; nothing where all do, or where there are none.
std::string errors_without_place(const Value& root, const Registry& registry) {
  Diagnostics diagnostics;
  LoadedScenario loaded;
  std::optional<Plan> plan = decode(root, registry, folder, diagnostics);
  if (plan.has_value() == diagnostics.has_errors()) return "decoded with errors, or refused without";
  if (plan) {
    loaded.root = root;
    loaded.plan = std::move(*plan);
    check_clearances(root, loaded.plan, true, diagnostics);
    try_runners(loaded, 3, diagnostics);
  }
  std::string lost;
  for (const Diagnostic& d : diagnostics.all())
    if (!d.at.source || d.at.line < 1 || d.at.column < 1) lost += to_text(d);
  return lost;
}

/// Tries each bad value at each place of each document, every `stride`-th of them.
void try_bad_values(std::size_t first, std::size_t stride) {
  const LuaSession session(FLYROCK_SHARE_DIR);
  std::vector<Value> values;
  for (const std::string& text : bad_values) values.push_back(bad_value(text));
  const Value sweep = read_value("v: { sweep: [9.81, 1.62] }").map()->front().value;
  std::size_t number = 0;
  for (auto& [name, root] : documents())
    for (const bool beside_a_sweep : {false, true}) {
      if (beside_a_sweep) {
        Value* gravity = root.find("gravity");
        const Location at = gravity->at;
        relocate(*gravity = sweep, at);
      }
      for (const Slot& slot : slots_of(root)) {
        if (beside_a_sweep && slot.path.starts_with("gravity")) continue;
        Value good = std::move(*slot.value);  // moved away and back: what is below stays where it is
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (number++ % stride != first) continue;
          *slot.value = values[i];
          relocate(*slot.value, good.at);
          INFO(name << ": " << slot.path << ": " << bad_values[i]
                    << (beside_a_sweep ? " beside a sweep" : ""));
          const auto start = std::chrono::steady_clock::now();
          const std::string lost = errors_without_place(root, session.registry());
          const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
          if (!lost.empty() || spent.count() > 5) FAIL_CHECK(lost << spent.count() << " s");
        }
        *slot.value = std::move(good);
      }
    }
  CHECK(number > 30000);
}

/// The path of a value without indices and names that a user gives: "materials.restitution",
/// "rocks.release.x".
std::string place_of(const std::string& path) {
  std::string place;
  bool is_name = false;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string step = path.substr(begin, end - begin);
    begin = end + 1;
    const bool is_index = step.find_first_not_of("0123456789") == std::string::npos;
    if (!is_index && !is_name) place += (place.empty() ? "" : ".") + step;
    is_name = step == "materials" && place == "materials" && !is_name;
  }
  return place;
}

}  // namespace

TEST_CASE("every key of the schema stands in a scenario of tests/scenarios/every_key, and these are sound") {
  const LuaSession session(FLYROCK_SHARE_DIR);
  std::set<std::string> found[2];
  for (auto& [name, root] : documents()) {
    INFO(name);
    Diagnostics diagnostics;
    const bool decoded = decode(root, session.registry(), folder, diagnostics).has_value();
    INFO(diagnostics.to_text());
    CHECK(decoded);
    const bool is_3d = *root.find("dimension")->number() == 3;
    for (const Slot& slot : slots_of(root)) found[is_3d].insert(place_of(slot.path));
  }
  for (const SectionSpec& section : section_specs()) {
    std::string place(section.name);
    if (place == "layer") continue;  // in place of points, and only with the module of GDAL
    const bool is_3d = place.find("3D") != std::string::npos;
    place = place.substr(0, std::min(place.find(':'), place.find(" 3D")));
    for (const std::string& key : section.key_names()) {
      if (key == "plugins" || key == "include") continue;  // are read before anything is decoded
      if (place == "orientation" && key != "type") place = "rocks.orientation";
      const std::string wanted = place.empty() ? key : place + "." + key;
      INFO(section.name << ": " << wanted);
      CHECK((found[is_3d].contains(wanted) || (!is_3d && found[1].contains(wanted))));
    }
  }
}

TEST_CASE("a sample of bad values at every key of the schema is refused at its place or taken") {
  try_bad_values(0, 47);
}

TEST_CASE("each bad value at every key of the schema is refused at its place or taken", "[heavy]") {
  try_bad_values(0, 1);
}
