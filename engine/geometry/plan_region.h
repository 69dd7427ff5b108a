#pragma once
// Regions in plan as polygons with holes, as maps have them.

#include <functional>
#include <vector>

#include "geometry/height_grid.h"
#include "geometry/mesh.h"

namespace flyrock {

/// A closed line in plan: its corners in order, the first one not repeated.
using PlanRing = std::vector<Vec2>;

struct PlanPolygon {
  PlanRing outline;             ///< counter-clockwise
  std::vector<PlanRing> holes;  ///< clockwise
};

/// The region where an odd number of rings is about a place. Rings may touch each other, and must not cross.
std::vector<PlanPolygon> polygons_of(std::vector<PlanRing> rings);

/// The borders of the cells of a grid whose value `is_inside` accepts; a cell is a square about its centre.
std::vector<PlanRing> rings_around_cells(const HeightGrid& grid,
                                         const std::function<bool(double value)>& is_inside);

/// The borders in plan of the triangles of one part of a mesh. An upright face has no area in plan, and no
/// ring.
std::vector<PlanRing> rings_around_part(const Mesh& mesh, int part);

}  // namespace flyrock
