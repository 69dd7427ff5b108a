// Scenarios in YAML and Lua, as trees and as text.

#include "corpus.h"
#include "document/yaml_reader.h"
#include "host/session.h"
#include "host/share.h"
#include "kind.h"
#include "mutate_text.h"
#include "mutate_tree.h"

namespace flyrock::fuzz {

namespace {

Dictionary dictionary_of_plugins() { return make_dictionary(LuaSession(share_folder()).registry()); }

/// `check`, and where the scenario is sound a run of two trials that ends early.
void check_and_run(const std::string& scenario, Calls& call) {
  if (call({"check", scenario}, ErrorForm::placed) != cli::done) return;
  call({"run", scenario, "-o", "out", "--force", "--quiet", "-j", "1", "--trials", "2", "--set",
        "stop.time=0.2"},
       ErrorForm::placed);
}

Value tree_of(const Source& source) {
  Diagnostics diagnostics;
  return read_yaml(source.text, source.name, diagnostics).value();
}

/// What lies beside a scenario; once in a while one of these files is the mutant.
bool write_beside(const Source& source, Dice& dice) {
  const bool mutant = !source.beside.empty() && dice.one_in(3);
  const std::size_t which = mutant ? dice.below(source.beside.size()) : source.beside.size();
  for (std::size_t i = 0; i < source.beside.size(); ++i) {
    auto [name, bytes] = source.beside[i];
    if (i == which) mutate_bytes(bytes, dice);
    write_here(name, bytes);
  }
  return mutant;
}

class YamlScenarios : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    const Source& source = dice.pick(sources_);
    std::string text = source.text;
    if (!write_beside(source, dice)) text = mutant_of(source, dice);
    write_here("s.yaml", text);
    check_and_run("s.yaml", call);
  }

 private:
  std::string mutant_of(const Source& source, Dice& dice) {
    const std::size_t way = dice.below(10);
    if (way < 7) {
      Value tree = tree_of(source);
      mutate_tree(tree, dictionary_, dice);
      return to_yaml(tree);
    }
    std::string text = source.text;
    if (way < 9)
      mutate_text(text, dictionary_, dice);
    else
      mutate_bytes(text, dice);
    return text;
  }

  Dictionary dictionary_ = dictionary_of_plugins();
  std::vector<Source> sources_ =
      sources_in({"scenarios", "plugins", "tests/fuzz/corpus/scenarios"}, ".yaml", {".csv"});
};

/// Trees of YAML scenarios written as Lua, and the text of Lua scenarios.
class LuaScenarios : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    write_here("s.lua", mutant(dice));
    check_and_run("s.lua", call);
  }

 private:
  std::string mutant(Dice& dice) {
    if (dice.one_in(3)) {
      Value tree = tree_of(dice.pick(trees_));
      mutate_tree(tree, dictionary_, dice);
      return to_lua_scenario(tree);
    }
    std::string text = dice.pick(sources_).text;
    if (dice.one_in(6))
      mutate_bytes(text, dice);
    else
      mutate_text(text, dictionary_, dice);
    return text;
  }

  Dictionary dictionary_ = dictionary_of_plugins();
  std::vector<Source> trees_ = sources_in({"scenarios"}, ".yaml");
  std::vector<Source> sources_ = sources_in({"scenarios", "tests/fuzz/corpus/scenarios"}, ".lua");
};

/// Manifests that flyrock ships, and a plugin in Lua of each kind, which a scenario beside them uses.
class PluginFiles : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    const bool own = !dice.one_in(4);
    const Source& source = own ? dice.pick(own_) : dice.pick(shipped_);
    std::string text = source.text;
    if (dice.one_in(6))
      mutate_bytes(text, dice);
    else
      mutate_text(text, dictionary_, dice);
    for (const Source& each : own_) write_here(each.file(), each.text);
    write_here(source.file(), text);
    if (call({"check", source.file()}, ErrorForm::placed) != cli::done || !own) return;
    write_here("quarry.yaml", quarry_);
    check_and_run("quarry.yaml", call);
  }

 private:
  Dictionary dictionary_ = dictionary_of_plugins();
  std::vector<Source> shipped_ = sources_in({"plugins"}, ".lua");
  std::vector<Source> own_ = sources_in({"tests/fuzz/corpus/plugins"}, ".lua");
  std::string quarry_ = read_source("tests/fuzz/corpus/plugins/quarry.yaml");
};

}  // namespace

std::unique_ptr<Kind> make_yaml_kind() { return std::make_unique<YamlScenarios>(); }
std::unique_ptr<Kind> make_lua_kind() { return std::make_unique<LuaScenarios>(); }
std::unique_ptr<Kind> make_plugin_kind() { return std::make_unique<PluginFiles>(); }

}  // namespace flyrock::fuzz
