#pragma once
// What Lua programmers expect and do not find in the sandbox.

#include <string_view>

namespace flyrock {

/// What to use instead of a global, or of a field of a library ("math.random"), that is left out; empty for
/// other names.
std::string_view instead_of(std::string_view name);

}  // namespace flyrock
