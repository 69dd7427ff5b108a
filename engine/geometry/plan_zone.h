#pragma once
// Zones of a terrain: regions in plan that are parts of their own.

#include <functional>
#include <string>
#include <vector>

#include "geometry/plan_region.h"
#include "geometry/terrain_shape.h"

namespace flyrock {

/// Whether a place lies inside of a simple polygon (its corners in order, either way round).
bool is_inside(const std::vector<Vec2>& polygon, const Vec2& place);

/// Whether a place lies inside of one of several polygons, and in none of the holes of that one.
bool is_inside(const std::vector<PlanPolygon>& polygons, const Vec2& place);

/// Why corners do not outline a simple polygon; empty if they do: at least three, no two edges that cross or
/// touch, an area.
std::string polygon_fault(const std::vector<Vec2>& polygon);

/// Makes the region of a polygon in plan the part `name` of a terrain. The triangles of a mesh are cut along
/// the outline, to 1 mm. A cell of a grid belongs to the region if its centre does. A plane becomes a square
/// mesh that reaches 1 km from its point.
TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name, const std::vector<Vec2>& polygon);

/// The same for the union of several polygons with holes, which may overlap.
TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name,
                        const std::vector<PlanPolygon>& polygons);

/// The same for a region that `covers` describes: a triangle, or a cell of a grid, belongs to it if its
/// centre does.
TerrainShape3 with_zone(TerrainShape3 shape, const std::string& name,
                        const std::function<bool(const Vec2&)>& covers);

}  // namespace flyrock
