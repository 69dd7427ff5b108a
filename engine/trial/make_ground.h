#pragma once
// The terrain of a trial from what its plugin answers: zones, faces and the origin of a scenario.

#include "collision/ground/terrain_2d.h"
#include "collision/ground/terrain_3d.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The profile with its zones and faces. Throws PluginError if it is none, or reaches too far.
Terrain2 profile_ground(Profile profile, const TerrainPlan& plan);

/// The terrain in 3D with its zones, counted from its origin. Throws PluginError if it is no ground, or
/// reaches too far.
Terrain3 shaped_ground(TerrainShape3 shape, const TerrainPlan& plan);

/// The profile, with its segments cut at the ends of zones. The names of the zones become names of parts.
Profile with_zones(Profile profile, const std::vector<Zone>& zones);

/// Whether a zone of a terrain in 3D that is a polygon or a raster covers a place in plan, in the coordinates
/// of the scenario.
bool covers(const Zone& zone, const Vec2& place);

/// The height in the cell of a grid that a place in plan lies in; nothing outside and where there is no data.
std::optional<double> value_at(const HeightGrid& grid, const Vec2& place);

}  // namespace flyrock
