#pragma once
// Places and coordinates as messages show them.

#include <string>

#include "math/space.h"

namespace flyrock {

/// A coordinate [m] with ten digits, which show a millimetre of national coordinates: "2600010.512".
std::string coordinate_text(double value);

/// "(2600010.512, 1200040)", "(5, 12.1, 0.25)"
std::string place_text(const Vec2& place);
std::string place_text(const Vec3& place);

}  // namespace flyrock
