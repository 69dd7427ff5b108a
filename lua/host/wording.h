#pragma once
// How messages of Lua code are worded: as all others.

#include "document/printable.h"
#include "document/wording.h"
#include "sandbox/wording.h"

namespace flyrock {

inline constexpr Wording wording{[](std::string_view text) { return printable(text); }, did_you_mean};

}  // namespace flyrock
