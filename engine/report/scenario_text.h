#pragma once
// The resolved scenario as the page shows it.

#include <string>

#include "document/value.h"

namespace flyrock {

/// to_yaml() with angles in degrees. It reads back as the same scenario: an angle of which no degrees read
/// back as the same double stays in rad.
std::string scenario_text(const Value& resolved);

}  // namespace flyrock
