#pragma once
// Scenarios of others: what they may not name.

#include <filesystem>

#include "document/diagnostics.h"
#include "document/value.h"

namespace flyrock {

/// Reports each text of a scenario that names a file outside of the scenario's folder: by `..`, an absolute
/// path or a link.
void refuse_outer_files(const Value& tree, const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace flyrock
