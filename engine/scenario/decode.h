#pragma once
// Decodes the tree of values into the typed plan.

#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "scenario/plan.h"

namespace flyrock {

/// What the command line adds to the file.
struct Overrides {
  std::vector<std::string> set;  ///< "path=value", value in YAML
  std::optional<std::uint64_t> seed = {}, trials = {};
  std::vector<std::string> arguments = {};  ///< "name=value", of the Lua files of the scenario
  bool confined = false;  ///< refuses native plugins, and files outside of the scenario's folder
};

/// Applies `--set`, `--seed` and `--trials` to the tree. A path must exist in it or be a known key.
void apply_overrides(Value& root, const Overrides& overrides, Diagnostics& diagnostics);

/// Walks to the place of a path and puts the value there. Adds keys that a map does not have yet: decoding
/// knows all keys, refuses unknown ones and names the nearest.
void set_path(Value& root, const std::string& path, Value value, const Location& at,
              Diagnostics& diagnostics);

/// The files of `plugins: [...]`. They are found before anything else is decoded because they decide which
/// names are known.
std::vector<std::pair<std::string, Location>> plugin_files(const Value& root, Diagnostics& diagnostics);

/// Decodes the tree; nothing if there are errors. `folder` is the folder of the scenario: the files that it
/// names are relative to it. `grounds`: those of the same scenario, decoded before; nullptr for none.
std::optional<Plan> decode(const Value& root, const Registry& registry, const std::string& folder,
                           Diagnostics& diagnostics, std::shared_ptr<GroundStore> grounds = nullptr);

}  // namespace flyrock
