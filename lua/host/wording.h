#pragma once
// The wording of messages of Lua code, the same as for all others.

#include "document/printable.h"
#include "document/wording.h"
#include "sandbox/wording.h"

namespace flyrock {

inline constexpr Wording wording{[](std::string_view text) { return printable(text); }, did_you_mean};

}  // namespace flyrock
