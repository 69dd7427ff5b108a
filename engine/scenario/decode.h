#pragma once
// The tree of values to the typed plan.

#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "scenario/scenario.h"

namespace flyrock {

/// What the command line says beside the file.
struct Overrides {
  std::vector<std::string> set;  ///< "path=value", value in YAML
  std::optional<std::uint64_t> seed = {}, trials = {};
};

/// Applies `--set`, `--seed` and `--trials` to the tree. A path must exist in it or be a known key.
void apply_overrides(Value& root, const Overrides& overrides, Diagnostics& diagnostics);

/// The files of `plugins: [...]`, before anything else is decoded (they decide what is known).
std::vector<std::pair<std::string, Location>> plugin_files(const Value& root, Diagnostics& diagnostics);

/// Decodes; nothing where there are errors. `folder` is that of the scenario, for files that it names.
std::optional<Plan> decode(const Value& root, const Registry& registry, const std::string& folder,
                           Diagnostics& diagnostics);

}  // namespace flyrock
