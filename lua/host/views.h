#pragma once
// The arguments of plugin functions after the parameters: contact, rock, blast, terrain and rng.

#include "host/view.h"
#include "plugin/contact_law.h"
#include "plugin/models.h"

namespace flyrock {

/// The views of a contact for a law: first that of the contact, then those of its fields that are tables:
/// `shape` and `partner`, if `reads` names them, and `history`, the law's memory by the names in its
/// manifest. The memory is the only view that Lua may write, with finite numbers.
std::vector<View> contact_views(lua_State* lua, const PluginSpec& spec);
/// The fields of RockView; position and outward are { x, y } in 2D. Method rock:direction(speed, elevation [,
/// azimuth]): a velocity, with angles in rad above the outward horizontal.
View rock_view(lua_State* lua);
/// The fields that `reads` declares, by their Lua names: blast.hole_diameter.
View blast_view(lua_State* lua, const PluginSpec& spec);
/// The fields of a TerrainView: dimension, x_min, x_max, faces; points in 2D; y_min, y_max in 3D. Methods
/// terrain:height(x [, y]) and terrain:normal(x [, y]).
View terrain_view(lua_State* lua);
/// Methods rng:uniform([low, high]), rng:normal(), rng:integer(low, high).
View random_view(lua_State* lua);

/// Pushes { x, y } in 2D, { x, y, z } in 3D.
void push_vector(lua_State* lua, const Vec3& vector, int dimension);

}  // namespace flyrock
