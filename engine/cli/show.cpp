#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

/// The origin that was found where the scenario gives none. Points of a sweep with origins of their own show
/// none.
void add_origin(const std::vector<Scenario>& points, Value& resolved) {
  const Vec3& origin = points.front().terrain.origin;
  Value* terrain = resolved.find("terrain");
  if (origin == Vec3::Zero() || !terrain || !terrain->find("type") || terrain->find("origin")) return;
  if (!std::all_of(points.begin(), points.end(),
                   [&](const Scenario& s) { return s.terrain.origin == origin; }))
    return;
  List coordinates;
  for (const double coordinate : origin) coordinates.push_back({coordinate, {}, false});
  terrain->map()->push_back({"origin", Location{}, Value{std::move(coordinates), Location{}, false}});
}

/// ", and run it with --arg stones=41"; empty without arguments. The functions ask for them again.
std::string with_arguments(const std::vector<std::string>& arguments) {
  return arguments.empty() ? "" : fmt::format(", and run it with --arg {}", fmt::join(arguments, " --arg "));
}

}  // namespace

int show(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("json", "as JSON in place of YAML");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const Overrides overrides = overrides_of(line);
  auto loaded = load(line.words[0], overrides, false);
  if (!loaded) return bad_input;
  Value& resolved = loaded->plan.resolved;
  add_origin(loaded->plan.points, resolved);
  std::string text;
  if (loaded->defines_plugins) {
    const std::string file = std::filesystem::path(line.words[0]).filename().string();
    name_plugin_file(resolved, file);
    if (!line.has("json"))
      text = fmt::format("# Its plugins are functions in {0}: keep this beside {0}{1}.\n", file,
                         with_arguments(overrides.arguments));
  }
  text += line.has("json") ? to_json(resolved) : to_yaml(resolved);
  if (text.empty() || text.back() != '\n') text += '\n';
  std::cout << text;
  return done;
}

}  // namespace flyrock::cli
