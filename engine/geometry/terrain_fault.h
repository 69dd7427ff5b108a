#pragma once
// What makes a terrain in 3D no ground.

#include <string>

#include "geometry/terrain_shape.h"

namespace flyrock {

/// What is wrong with a grid: fewer than 2 x 2 heights, a cell without a size, heights that are infinite, a
/// part that does not exist, no square with four heights. Empty if nothing is.
std::string fault(const HeightGrid& grid);

/// What is wrong with a terrain; empty if nothing is. See mesh_fault.h; a plane has a finite point and a unit
/// normal that points upwards.
std::string fault(const TerrainShape3& shape);

}  // namespace flyrock
