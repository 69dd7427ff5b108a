#pragma once
// The table given to fr.plugin to a PluginSpec.

#include <map>
#include <optional>
#include <string>

#include "document/diagnostics.h"
#include "plugin/spec.h"

namespace flyrock {

/// The function that a pure Lua plugin of a kind defines: "impact", "build", ...
std::string_view entry_point(PluginKind kind);

/// Checks a manifest and reports all that is wrong with it, each at its place. `functions` are the
/// fields that hold functions, with their places. Limits and defaults are converted from the declared unit to
/// SI; parameters are sorted by name, since a Lua table has no order. Nothing where there are errors.
std::optional<PluginSpec> read_manifest(const Value& table, const std::map<std::string, Location>& functions,
                                        Diagnostics& diagnostics);

}  // namespace flyrock
