#pragma once
// What a terrain plugin answers in 3D.

#include <variant>

#include "geometry/height_grid.h"
#include "geometry/mesh.h"
#include "geometry/plane.h"

namespace flyrock {

using TerrainShape3 = std::variant<Plane, Mesh, HeightGrid>;

}  // namespace flyrock
