#pragma once
// Reads one parameter of a manifest.

#include <optional>
#include <string_view>
#include <vector>

#include "document/diagnostics.h"
#include "document/value.h"
#include "plugin/spec.h"

namespace flyrock {

/// Whether a name has only lower-case letters, digits and _, and begins with a letter: for plugins,
/// parameters and histories.
bool is_identifier(std::string_view name);

inline constexpr std::size_t most_letters = 100;  ///< of the name of a plugin or of a parameter

/// Reads one entry of `params`: fr.number { ... } or another type. Its default and limits are converted to
/// SI. An fr.group { params = { ... } } gives one ParamSpec for each of its parameters, named NAME.OTHER.
/// Errors are reported, and the answer is then nullopt.
std::optional<std::vector<ParamSpec>> read_param(const Entry& entry, Diagnostics& diagnostics);

/// Reports bounds that do not name another number of the same plugin with the same unit, and defaults that
/// violate bounds. Returns whether all are sound. `written` is the table `params`.
bool check_bounds(const Map& written, const std::vector<ParamSpec>& params, Diagnostics& diagnostics);

}  // namespace flyrock
