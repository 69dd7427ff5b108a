#pragma once
// Reads YAML text into the tree of located values.

#include <optional>
#include <string>

#include "document/diagnostics.h"
#include "document/value.h"

namespace flyrock {

/// A longer text is not read as a scenario.
inline constexpr std::size_t most_yaml_bytes = 4 << 20;

/// Reads one YAML document. Errors: not YAML, more than one document, a duplicate key, a key that is not
/// text, a merge key `<<`, a tag, an alias cycle or more than 100,000 values (aliases expanded), .nan and
/// .inf.
std::optional<Value> read_yaml(const std::string& text, const std::string& name, Diagnostics& diagnostics);

}  // namespace flyrock
