#include "cli/loading.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/terminal.h"
#include "document/node.h"
#include "host/share.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The file of a given name, or that of the shipped scenario with the name.
std::string scenario_file(const std::string& name) {
  std::error_code fault;  // of a name that no file can have
  if (fs::path(name).is_absolute() || fs::exists(name, fault) || fault) return name;
  for (const char* ending : {"", ".yaml", ".lua"})
    if (const fs::path shipped = fs::path(share_folder()) / "scenarios" / (name + ending);
        fs::is_regular_file(shipped, fault))
      return shipped.string();
  return name;
}

}  // namespace

void add_override_options(po::options_description& options) {
  options.add_options()("set", po::value<std::vector<std::string>>()->value_name("path=value"),
                        "sets a value of the scenario; may be given several times")(
      "seed", po::value<std::string>()->value_name("S"), "in place of the scenario's seed")(
      "trials", po::value<std::string>()->value_name("N"), "in place of the scenario's number of trials")(
      "arg", po::value<std::vector<std::string>>()->value_name("name=value"),
      "a value for fr.argument(name, default) of a Lua scenario; may be given several times")(
      "confined",
      "refuses native plugins, and files outside of the scenario's folder: for scenarios of others");
}

Overrides overrides_of(const CommandLine& line) {
  Overrides overrides;
  if (line.has("set")) overrides.set = line.options["set"].as<std::vector<std::string>>();
  if (line.has("seed")) overrides.seed = whole_number(line.text("seed"), "--seed", 0);
  if (line.has("trials")) overrides.trials = whole_number(line.text("trials"), "--trials", 1);
  if (line.has("arg")) overrides.arguments = line.options["arg"].as<std::vector<std::string>>();
  overrides.confined = line.has("confined");
  return overrides;
}

std::optional<LoadedScenario> load(const std::string& path, const Overrides& overrides, bool strict) {
  Diagnostics diagnostics;
  std::optional<LoadedScenario> loaded =
      load_scenario(overrides.confined ? path : scenario_file(path), overrides, diagnostics);
  if (strict) diagnostics.be_strict();
  if (strict && loaded)
    for (const std::string& key : loaded->plan.not_used)  // "blast.spacing (bench_fit does not read it)"
      diagnostics.error(node_at(loaded->root, key.substr(0, key.find_first_of(" :"))).key_at, "",
                        "not used: " + key);
  const std::string text = diagnostics.to_text();
  if (!text.empty()) tell("{}{}", text, text.back() == '\n' ? "" : "\n");
  return diagnostics.has_errors() ? std::nullopt : std::move(loaded);
}

}  // namespace flyrock::cli
