#pragma once
// Where the zones of a terrain in 3D are, in plan.

#include <vector>

#include "geometry/plan_region.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The region of a zone as its scenario describes it: its polygon, the polygons of its file, or the cells of
/// its raster. Of a zone that names a part of a mesh, the triangles of `ground`, where rocks were; null: no
/// ground is known.
std::vector<PlanPolygon> region_of(const Zone& zone, const Mesh* ground);

}  // namespace flyrock
