#pragma once
// One parameter of a manifest.

#include <optional>
#include <string_view>
#include <vector>

#include "document/diagnostics.h"
#include "plugin/spec.h"

namespace flyrock {

/// Small letters, digits and _, a letter first: names of plugins, parameters and histories.
bool is_identifier(std::string_view name);

inline constexpr std::size_t most_letters = 100;  ///< of the name of a plugin or of a parameter

/// An fr.number { ... } or the like, under `params.NAME`, with its default and limits converted to SI.
/// Nothing where there are errors, which are reported.
std::optional<ParamSpec> read_param(const Entry& entry, Diagnostics& diagnostics);

/// Reports the bounds that name no other number of the same plugin and unit, and defaults that break them;
/// whether all are sound. `written` holds the parameters in the order of `params`.
bool check_bounds(const Map& written, const std::vector<ParamSpec>& params, Diagnostics& diagnostics);

}  // namespace flyrock
