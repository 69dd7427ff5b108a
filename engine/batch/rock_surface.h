#pragma once
// The surface of a rock, for pictures.

#include <vector>

#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "record/scenery.h"
#include "world/body.h"

namespace flyrock {

/// The corners of all faces.
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors);
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor3>& contactors);
/// The same of a body; a deformable block has one face through its nodes, in 3D a triangle for each side of
/// its mesh.
std::vector<SurfaceCorner> surface_of(const Body<2>& body);
std::vector<SurfaceCorner> surface_of(const Body<3>& body);

}  // namespace flyrock
