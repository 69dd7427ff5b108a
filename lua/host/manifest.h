#pragma once
// Reads the table given to fr.plugin into a PluginSpec.

#include <map>
#include <optional>
#include <string>

#include "document/diagnostics.h"
#include "plugin/spec.h"

namespace flyrock {

struct Value;

/// The name of the function that a pure Lua plugin of a kind defines: "impact", "build", ...
std::string_view entry_point(PluginKind kind);

/// Checks a manifest and reports all its errors, each at its place. `functions` are the fields with
/// functions, and their places. Limits and defaults are converted from the declared unit to SI. Parameters
/// are sorted by name, because a Lua table has no order. Nothing if there are errors.
std::optional<PluginSpec> read_manifest(const Value& table, const std::map<std::string, Location>& functions,
                                        Diagnostics& diagnostics);

}  // namespace flyrock
