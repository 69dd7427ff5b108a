// The JSON Schema of scenarios accepts what `check` accepts and refuses wrong types, unknown names and
// missing keys, for every key of the schema and every parameter of every plugin. Needs python3-jsonschema and
// says SKIPPED without.

#include "scenario/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "cli/program.h"
#include "document/node.h"
#include "document/yaml_reader.h"
#include "host/session.h"
#include "scenario/decode.h"
#include "units/units.h"

namespace flyrock::schema_test {

using namespace flyrock::test;

struct Document {
  fs::path file;
  Value root;
  std::string folder() const { return file.parent_path().string(); }
};

/// A document with one change, and what `check` says of it.
struct Mutant {
  std::string what, json, errors;
};

bool has_jsonschema() {
  const Folder folder;
  return shell(folder, "python3 -c 'import jsonschema'").code == 0;
}

/// Which of these documents the schema accepts. The validator reads one of them a line.
std::vector<bool> accepted_by_schema(const Folder& folder, const std::vector<std::string>& documents) {
  std::string lines;
  for (std::string json : documents) {
    std::replace(json.begin(), json.end(), '\n', ' ');
    lines += json + '\n';
  }
  folder.write("documents", lines);
  folder.write("validate.py", R"(import json, jsonschema
with open("schema.json") as file: schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
with open("documents") as file:
  for line in file: print(int(validator.is_valid(json.loads(line))))
)");
  REQUIRE(call(folder, "schema > schema.json").code == 0);
  const Output output = shell(folder, "python3 validate.py");
  INFO(output.err);
  REQUIRE(output.code == 0);
  std::vector<bool> accepted;
  for (const char c : output.out)
    if (c != '\n') accepted.push_back(c == '1');
  REQUIRE(accepted.size() == documents.size());
  return accepted;
}

Document read_document(const fs::path& file) {
  Diagnostics diagnostics;
  std::optional<Value> root = read_yaml(read(file), file.string(), diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(root);
  return {file, std::move(*root)};
}

std::vector<Document> documents_in(const fs::path& folder) {
  std::vector<Document> documents;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".yaml") documents.push_back(read_document(entry.path()));
  std::sort(documents.begin(), documents.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return documents;
}

class Mutants {
 public:
  explicit Mutants(const LuaSession& session) : session_(session) {}
  std::vector<Mutant> made;

  void add(const Document& of, const std::string& what) {
    Diagnostics diagnostics;
    const std::optional<Plan> plan = decode(of.root, session_.registry(), of.folder(), diagnostics);
    made.push_back({of.file.filename().string() + ": " + what, to_json(of.root, 0),
                    plan && !diagnostics.has_errors() ? "" : diagnostics.to_text()});
  }

  /// Values of another type in place of `slot`.
  void change_type(Document& of, Value& slot, const std::string& what) {
    for (const Value& other : others(slot)) {
      Value good = std::move(slot);
      slot = other;
      slot.at = good.at;
      add(of, "type of " + what);
      slot = std::move(good);
    }
  }
  void add_unknown(Document& of, Value& map, const std::string& what) {
    map.map()->push_back({"oops_key", map.at, Value{1.0, map.at}});
    add(of, "unknown key in " + what);
    map.map()->pop_back();
  }
  void leave_out(Document& of, Value& map, std::size_t i, const std::string& what) {
    const Entry entry = (*map.map())[i];
    map.map()->erase(map.map()->begin() + static_cast<std::ptrdiff_t>(i));
    add(of, "without " + what);
    map.map()->insert(map.map()->begin() + static_cast<std::ptrdiff_t>(i), entry);
  }

 private:
  static std::vector<Value> others(const Value& good) {
    const Value list{List{}, {}}, truth{true, {}}, twelve{12.0, {}}, oops{std::string("oops"), {}};
    if (good.number() || (good.text() && parse_quantity(*good.text()))) return {truth, oops, list};
    if (good.boolean()) return {twelve, list};
    if (good.text()) return {list};
    if (good.map()) return {oops, Value{List{truth}, {}}};
    return {oops, twelve};
  }

  const LuaSession& session_;
};

/// Changes each key of a document once, by its place without indices.
class KeyWalk {
 public:
  KeyWalk(Mutants& mutants, std::set<std::string>& seen, std::size_t stride)
      : mutants_(mutants), seen_(seen), stride_(stride) {}

  void walk(Document& document) {
    const Value* dimension = document.root.find("dimension");
    stem_ = dimension && dimension->number() && *dimension->number() == 3 ? "3D " : "2D ";
    replaced_.clear();
    if (const Value* sweep = document.root.find("sweep"))
      if (const Value* rows = sweep->find("rows"); rows && rows->list())
        for (const Value& row : *rows->list())
          for (const Entry& entry : *row.map()) replaced_.insert(entry.key);
    visit(document, document.root, "");
  }

 private:
  static bool is_free(const std::string& place) {  // names and paths of the user
    return place == "materials" || place == "terrain.materials" || place == "branches.set" ||
           place == "expect.at" || place == "sweep.rows";
  }
  bool is_turn(const std::string& what) {
    return seen_.insert(stem_ + what).second && count_++ % stride_ == 0;
  }

  void visit(Document& document, Value& value, const std::string& place) {
    if (Map* map = value.map()) {
      const Value* type = value.find("type");
      const std::string kind = type && type->text() ? place + " " + *type->text() : place;
      if (!is_free(place) && is_turn("+" + kind)) mutants_.add_unknown(document, value, kind);
      for (std::size_t i = 0; i < map->size(); ++i) {
        const std::string key = is_free(place)  ? place
                                : place.empty() ? (*map)[i].key
                                                : place + "." + (*map)[i].key;
        if (place == "branches.set" || place == "expect.at" || place == "sweep.rows") continue;
        if (!is_free(place) && is_turn("-" + kind + key))
          mutants_.leave_out(document, value, i, kind + ": " + key);
        if (!replaced_.contains(key) && is_turn("~" + kind + key))
          mutants_.change_type(document, (*map)[i].value, kind + ": " + key);
        visit(document, (*map)[i].value, is_free(place) ? place + ".NAME" : key);
      }
    }
    if (List* list = value.list())
      for (Value& item : *list) visit(document, item, place);
  }

  Mutants& mutants_;
  std::set<std::string>& seen_;
  std::size_t stride_, count_ = 0;
  std::string stem_;
  std::set<std::string> replaced_;  ///< paths whose value the rows of a design replace
};

/// A use of a plugin in a tree; null if there is none.
Value* use_of(Value& value, const std::string& type, const std::string& place, PluginKind kind) {
  const std::string own(kind == PluginKind::population ? "rocks"
                        : kind == PluginKind::velocity ? "launch"
                                                       : name_of(kind));
  if (Map* map = value.map()) {
    const Value* named = value.find("type");
    if (place == own && named && named->text() && *named->text() == type) return &value;
    for (Entry& entry : *map)
      if (Value* found = use_of(entry.value, type, entry.key == "parts" ? "shape" : entry.key, kind))
        return found;
  }
  if (List* list = value.list())
    for (Value& item : *list)
      if (Value* found = use_of(item, type, place, kind)) return found;
  return nullptr;
}

Value* entry_of(Value& map, const std::string& key) {
  if (!map.find(key)) map.map()->push_back({key, map.at, Value{Map{}, map.at}});
  return map.find(key);
}

/// Changes each parameter of a plugin in its example.
void change_parameters(Mutants& mutants, const PluginSpec& spec, Document& example) {
  // They may be of the points of a sweep.
  std::erase_if(*example.root.map(), [](const Entry& entry) { return entry.key == "expect"; });
  const Value original = example.root;
  for (const ParamSpec& param : spec.params) {
    const std::string what = fmt::format("{}/{}: {}", name_of(spec.kind), spec.name, param.name);
    Value* use = use_of(example.root, spec.name, "", spec.kind);
    INFO(what);
    REQUIRE(use);
    Value* holder = param.group().empty() ? use : entry_of(*use, std::string(param.group()));
    const std::string key(param.own_name());
    const bool is_given = holder->find(key);
    Value* slot = entry_of(*holder, key);
    if (!is_given)
      slot->data =
          param.type == ParamType::number || param.type == ParamType::integer ? Value{1.0, {}}.data
          : param.type == ParamType::boolean                                  ? Value{true, {}}.data
          : param.type == ParamType::choice || param.type == ParamType::text || param.type == ParamType::file
              ? Value{std::string("some"), {}}.data
              : Value{List{}, {}}.data;
    mutants.change_type(example, *slot, what);
    if (is_given && param.required())
      for (std::size_t i = 0; i < holder->map()->size(); ++i)
        if ((*holder->map())[i].key == key) mutants.leave_out(example, *holder, i, what);
    example.root = original;
  }
  Value* use = use_of(example.root, spec.name, "", spec.kind);
  REQUIRE(use);
  mutants.add_unknown(example, *use, spec.name);
}

bool says(const std::string& errors, const char* part) { return errors.find(part) != std::string::npos; }

/// Whether `check` refuses a mutant by its form, which the schema must refuse too.
bool is_wrong_form(const Mutant& mutant) {
  if (mutant.errors.empty() || says(mutant.errors, "there is no file `oops`")) return false;
  if (says(mutant.what, "without "))  // not: what another key beside it needs
    return says(mutant.errors, " is missing, expected") || says(mutant.errors, " is missing\n");
  if (says(mutant.what, "unknown key")) return says(mutant.errors, "oops_key");
  // A text may be the name of a file, or of a shape of the scenario.
  if (says(mutant.errors, "there is no file") || says(mutant.errors, "`shapes` has no `oops`")) return false;
  return true;
}

void compare(const std::vector<Mutant>& mutants, std::size_t at_least) {
  const Folder folder;
  std::vector<std::string> documents;
  for (const Mutant& mutant : mutants) documents.push_back(mutant.json);
  const std::vector<bool> accepted = accepted_by_schema(folder, documents);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    const bool must_refuse = is_wrong_form(mutants[i]);
    wrong += must_refuse;
    INFO(mutants[i].what << "\n" << mutants[i].errors);
    if (must_refuse && accepted[i]) FAIL_CHECK("the schema accepts it");
    if (mutants[i].errors.empty() && !accepted[i]) FAIL_CHECK("the schema refuses what check accepts");
  }
  CHECK(wrong >= at_least);
}

TEST_CASE("the JSON Schema accepts every scenario, example and scenario of all keys", "[slow]") {
  if (!has_jsonschema()) {
    WARN("SKIPPED: no python3-jsonschema");
    return;
  }
  std::vector<std::string> json, names;
  for (const char* folder : {FLYROCK_SOURCE_DIR "/scenarios", FLYROCK_SOURCE_DIR "/plugins",
                             FLYROCK_SOURCE_DIR "/tests/scenarios/every_key"})
    for (const Document& document : documents_in(folder)) {
      json.push_back(to_json(document.root, 0));
      names.push_back(document.file.string());
    }
  const Folder folder;
  const std::vector<bool> accepted = accepted_by_schema(folder, json);
  CHECK(accepted.size() > 80);
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    INFO(names[i]);
    CHECK(accepted[i]);
  }
}

std::vector<Mutant> key_mutants(std::size_t stride) {
  const LuaSession session(FLYROCK_SHARE_DIR);
  Mutants mutants(session);
  std::set<std::string> seen;
  for (Document& document : documents_in(FLYROCK_SOURCE_DIR "/tests/scenarios/every_key"))
    KeyWalk(mutants, seen, stride).walk(document);
  return mutants.made;
}

TEST_CASE(
    "a sample of keys: wrong types, unknown names and missing keys are refused by the JSON Schema as by "
    "check") {
  if (!has_jsonschema()) {
    WARN("SKIPPED: no python3-jsonschema");
    return;
  }
  compare(key_mutants(40), 30);
}

TEST_CASE("every key: wrong types, unknown names and missing keys are refused by the JSON Schema as by check",
          "[heavy]") {
  if (!has_jsonschema()) {
    WARN("SKIPPED: no python3-jsonschema");
    return;
  }
  compare(key_mutants(1), 900);
}

TEST_CASE("every parameter: wrong types and missing ones are refused by the JSON Schema as by check",
          "[slow]") {
  if (!has_jsonschema()) {
    WARN("SKIPPED: no python3-jsonschema");
    return;
  }
  const LuaSession session(FLYROCK_SHARE_DIR);
  Mutants mutants(session);
  for (int k = 0; k < plugin_kinds; ++k)
    for (const Plugin* plugin : session.registry().of_kind(static_cast<PluginKind>(k))) {
      const PluginSpec& spec = plugin->spec;
      Document example = read_document(fs::path(FLYROCK_SOURCE_DIR "/plugins") / name_of(spec.kind) /
                                       spec.name / "example.yaml");
      change_parameters(mutants, spec, example);
    }
  compare(mutants.made, 500);
}

}  // namespace flyrock::schema_test
