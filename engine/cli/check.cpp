#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "cli/given_parameters.h"
#include "cli/loading.h"
#include "cli/not_used_line.h"
#include "cli/plugin_file.h"
#include "cli/runners.h"
#include "cli/terminal.h"
#include "document/printable.h"
#include "files/safe_file.h"
#include "host/share.h"
#include "load/try_points.h"
#include "plugin/conformance.h"
#include "results/compare/observation.h"
#include "results/compare/starts.h"
#include "results/measured/block_summary.h"
#include "results/say/answer.h"

namespace flyrock::cli {

namespace {

/// "a sound scenario", or what the reader must look at first: a warning says that something may be wrong.
std::string verdict(std::size_t warnings) {
  if (warnings == 0) return "a sound scenario";
  return fmt::format("no error, {} warning{}", warnings, warnings == 1 ? "" : "s");
}

/// Loads a plugin file or folder and tries its plugins on sampled states, with the parameters of --set and
/// sampled ones.
int check_plugin(const std::string& path, const Overrides& overrides) {
  if (overrides.seed || overrides.trials)
    throw UsageError("--seed and --trials belong to a scenario; a plugin is tried on states of its own");
  LuaSession session(share_folder());
  Diagnostics diagnostics;
  session.arguments().give(overrides.arguments, diagnostics);
  const std::optional<std::vector<const Plugin*>> plugins = load_plugin_file(session, path);
  session.arguments().refuse_unasked(diagnostics);
  tell("{}", diagnostics.to_text());
  if (!plugins || diagnostics.has_errors()) return bad_input;
  bool faulty = false, untried = false;
  for (const Plugin* plugin : *plugins) {
    const auto say = [&](const char* grade, const std::string& text) {
      tell("{}: {}: {}/{}: {}\n", place_of(plugin->spec), grade, name_of(plugin->spec.kind),
           plugin->spec.name, text);
    };
    const int dimension = plugin->spec.dimension == 3 ? 3 : 2;
    const auto given = decode_given(session.registry(), plugin->spec, overrides.set, dimension);
    if (!given) return bad_input;
    const Conformance found = conformance(*plugin, *given);
    for (const std::string& fault : found.faults) say("error", fault);
    for (const std::string& what : found.not_called) say("warning", what);
    if (!found.whole) say("warning", "its calls take so long that only some of the samples were tried");
    faulty = faulty || !found.faults.empty();
    untried = untried || !found.not_called.empty() || !found.whole;
  }
  if (faulty) return bad_input;
  fmt::print("{}: {}\n", path, untried ? "no fault in what was called" : "a sound plugin");
  return done;
}

int check_scenario(const std::string& path, const Overrides& overrides, bool strict) {
  std::optional<LoadedScenario> loaded = load(path, overrides, strict);
  if (!loaded) return bad_input;
  const Plan& plan = loaded->plan;
  if (!try_runners(*loaded, tried_trials)) return bad_input;
  for (const std::string& table : plan.points.front().tables) fmt::print("{}\n", printable(table, 2000));
  fmt::print("{}", not_used_list(plan.not_used));
  if (const std::string elevations = assumed_elevations(plan); !elevations.empty())
    fmt::print("{}\n", elevations);
  if (const std::string trees = assumed_trees(plan); !trees.empty()) fmt::print("{}\n", trees);
  if (!loaded->tiers.empty()) fmt::print("{}\n", loaded->tiers);
  if (!loaded->pile_cost.empty()) fmt::print("{}\n", loaded->pile_cost);
  if (!loaded->deformable.empty()) fmt::print("{}\n", loaded->deformable);
  if (const std::string ground = surveyed_ground(plan); !ground.empty()) fmt::print("{}\n", ground);
  if (const Scenario& first = plan.points.front(); first.observed)
    fmt::print("observed: {}\n",
               measured_text(*first.observed, measured(*first.observed, starts_of(first, tried_trials))));
  if (const std::string blocks = blocks_of_first_trial(plan.points.front()); !blocks.empty())
    fmt::print("{}\n", blocks);
  const std::uint64_t trials = plan.points.front().trials;
  const std::string each =
      plan.axes.empty() ? "" : fmt::format(" at each of {} sweep points", plan.points.size());
  fmt::print("{}: {}, {} trial{}{}\n", path, verdict(loaded->warnings.size()), trials, trials == 1 ? "" : "s",
             each);
  return done;
}

/// A folder is always a plugin. A Lua file is a plugin if it never calls fr.scenario. For a file that cannot
/// be read the scenario reader reports the reason.
bool is_plugin(const std::string& path) {
  if (std::filesystem::is_directory(path)) return true;
  std::error_code code;
  if (std::filesystem::path(path).extension() != ".lua" || !std::filesystem::is_regular_file(path, code))
    return false;
  return read_file(path).find(".scenario") == std::string::npos;
}

}  // namespace

int check(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  add_override_options(options);
  options.add_options()("strict", "treats unused keys and unusual values as errors");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const std::string& path = line.words[0];
  const Overrides overrides = overrides_of(line);
  try {
    return is_plugin(path) ? check_plugin(path, overrides)
                           : check_scenario(path, overrides, line.has("strict"));
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {  // nothing runs here, so the error is in the file
    tell("{}: error: {}\n", path, error.what());
    return bad_input;
  }
}

}  // namespace flyrock::cli
