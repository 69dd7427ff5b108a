#pragma once
// The cells of the maps of a scenario.

#include "collision/ground/terrain_3d.h"
#include "record/maps.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The cells of the maps of a scenario in 3D over its ground, in the coordinates of the scenario. Cells: as
/// the plan says; else those of a raster, in groups of n x n if there are too many; else a 200th of the
/// longer side, rounded up to 1, 2 or 5 times a power of ten. Empty if the plan wants no maps, or if the
/// ground has no ends and the plan no region. Throws ScenarioError if the plan asks for cells that cannot be
/// made.
PlanGrid map_grid(const Scenario& scenario, const Terrain3& terrain);

}  // namespace flyrock
