#pragma once
// What plugins are passed beside their parameters: contact, rock, blast, terrain and rng.

#include "host/view.h"
#include "plugin/contact_law.h"
#include "plugin/models.h"

namespace flyrock {

/// With `history`, its field `history` is that view, pointed at the contact's memory.
View contact_view(lua_State* lua, const View* history = nullptr);
/// What a law remembers, by the names of its manifest; the one view that may be written, with finite numbers.
View history_view(lua_State* lua, const PluginSpec& spec);
/// Fields of RockView; position and outward are { x, y } in 2D. Method rock:direction(speed, elevation
/// [, azimuth]): the velocity above the outward horizontal, in rad.
View rock_view(lua_State* lua);
/// The fields that `reads` declares, by their Lua names: blast.hole_diameter.
View blast_view(lua_State* lua, const PluginSpec& spec);
/// x_min, x_max, points, faces; method terrain:height(x).
View terrain_view(lua_State* lua);
/// Methods rng:uniform([low, high]), rng:normal(), rng:integer(low, high).
View random_view(lua_State* lua);

/// Pushes { x, y } in 2D, { x, y, z } in 3D.
void push_vector(lua_State* lua, const Vec3& vector, int dimension);

}  // namespace flyrock
