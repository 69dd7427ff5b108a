#pragma once
// From the path of a scenario to a plan that can be run.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/session.h"
#include "scenario/decode.h"

namespace flyrock {

/// A plugin source, or a file that a parameter names, and the hash of its text.
struct SourceHash {
  std::string name;
  std::string sha256;
};

struct LoadedScenario {
  std::unique_ptr<LuaSession> session;  ///< owns the plugins that the plan points to
  Value root;  ///< the tree as it was read, with the overrides: says where a key stands
  Plan plan;
  std::string name;                 ///< the file's name without its extension
  std::vector<SourceHash> sources;  ///< every plugin source that was loaded
  std::vector<SourceHash> files;    ///< every file that a parameter names: a profile, a polyhedron
  std::string hash;  ///< SHA-256 of the engine's version, the resolved scenario, the sources and the files
  std::vector<std::string> warnings;  ///< of the reader: "blast.hole: the hole is shorter than the bench"
  bool defines_plugins = false;       ///< a Lua scenario with calls of fr.plugin
  std::uint64_t own_trials = 1;       ///< `trials` of the file, before `--trials`
};

/// What `print` of Lua code does while a scenario is read: to stderr, or kept in the session.
enum class Prints { shown, collected };

/// Reads `path` (.yaml, .yml or .lua), loads the plugin files that it names, from its own folder, applies
/// `overrides` and decodes. Nothing where there are errors; all of them are in `diagnostics`.
std::optional<LoadedScenario> load_scenario(const std::string& path, const Overrides& overrides,
                                            Diagnostics& diagnostics, Prints prints = Prints::shown);

}  // namespace flyrock
