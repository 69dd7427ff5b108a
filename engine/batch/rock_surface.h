#pragma once
// The surface of a rock, for pictures.

#include <vector>

#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "record/scenery.h"

namespace flyrock {

/// The corners of all faces.
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors);
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor3>& contactors);

}  // namespace flyrock
