#pragma once
// Tells whether two bodies have the same shape in the same frame.

#include <string>
#include <vector>

#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

/// A hash (FNV-1a, 16 hexadecimal digits) of the forms, places and radii of contactors, to the last bit.
/// Bodies of equal codes are in contact in the same way at the same place and orientation.
std::string shape_code(const std::vector<Contactor2>& contactors);
std::string shape_code(const std::vector<Contactor3>& contactors);

}  // namespace flyrock
