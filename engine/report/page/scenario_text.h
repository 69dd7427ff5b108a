#pragma once
// The resolved scenario as the page shows it.

#include <string>

#include "document/value.h"

namespace flyrock {

/// The tree with angles in degrees, as scenario_text().
Value in_degrees(Value resolved);

/// to_yaml() with angles in degrees. It reads back as the same scenario: an angle stays in rad if no text in
/// degrees reads back as the same double.
std::string scenario_text(const Value& resolved);

}  // namespace flyrock
