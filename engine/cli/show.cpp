#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "cli/loading.h"

namespace flyrock::cli {

namespace {

/// A tree cannot hold the functions of a Lua scenario. It therefore names the scenario's file under
/// `plugins`.
void name_plugin_file(Value& resolved, const std::string& file) {
  if (Value* plugins = resolved.find("plugins"); plugins && plugins->list())
    plugins->list()->push_back({file, {}, false});
}

}  // namespace

int show(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("json", "as JSON in place of YAML");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  auto loaded = load(line.words[0], overrides_of(line), false);
  if (!loaded) return bad_input;
  Value& resolved = loaded->plan.resolved;
  std::string text;
  if (loaded->defines_plugins) {
    const std::string file = std::filesystem::path(line.words[0]).filename().string();
    name_plugin_file(resolved, file);
    if (!line.has("json"))
      text = fmt::format("# Its plugins are functions in {0}: keep this beside {0}.\n", file);
  }
  text += line.has("json") ? to_json(resolved) : to_yaml(resolved);
  if (text.empty() || text.back() != '\n') text += '\n';
  std::cout << text;
  return done;
}

}  // namespace flyrock::cli
