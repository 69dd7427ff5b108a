#pragma once
// Loads a scenario: from its path to a plan that can be run.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/session.h"
#include "scenario/decode.h"

namespace flyrock {

/// A plugin source, or a file that a parameter names, with the hash of its text.
struct SourceHash {
  std::string name;
  std::string sha256;
};

struct LoadedScenario {
  std::unique_ptr<LuaSession> session;  ///< owns the plugins that the plan points to
  Value root;                           ///< the tree as read, with the overrides; gives the place of each key
  Plan plan;
  std::string name;                 ///< the file's name without its extension
  std::vector<SourceHash> sources;  ///< all loaded plugin sources
  std::vector<SourceHash> files;    ///< all files that parameters name: a profile, a polyhedron
  /// SHA-256 of the engine's version, the resolved scenario, the sources, the files and the arguments
  std::string hash;
  std::vector<std::string> warnings;  ///< from the reader: "blast.hole: the hole is shorter than the bench"
  std::string tiers;                  ///< from trying it out: which shapes have less exact contacts
  std::string pile_cost;              ///< and what piles of many bodies may cost
  std::string deformable;             ///< and how deformable bodies touch
  bool defines_plugins = false;       ///< a Lua scenario that calls fr.plugin
  std::uint64_t own_trials = 1;       ///< `trials` of the file, without `--trials`
};

/// Where `print` of Lua code goes while a scenario is read: to stderr, or into the session.
enum class Prints { shown, collected };

/// Reads `path` (.yaml, .yml or .lua), loads the plugin files that it names relative to its folder, applies
/// `overrides` and decodes. Nothing if there are errors; all of them are in `diagnostics`. `before`: the same
/// scenario, loaded before in this process; its grounds and the hashes of its data files are taken over, so
/// that each of these files is read and hashed once.
std::optional<LoadedScenario> load_scenario(const std::string& path, const Overrides& overrides,
                                            Diagnostics& diagnostics, Prints prints = Prints::shown,
                                            const LoadedScenario* before = nullptr);

}  // namespace flyrock
