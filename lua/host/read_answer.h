#pragma once
// The tables that plugins return to what the engine takes. A wrong answer is a PluginError that names the
// field: "plugin my_shape, my_shape.lua:9: build() returned vertices[1] = text, expected { x, y }".

#include "document/value.h"
#include "host/lua_call.h"
#include "plugin/models.h"

namespace flyrock {

/// The result at the top of the stack as a tree.
Value answer_tree(const LuaCall& call, lua_State* lua);

/// { radius = r [, centre = { x, y }] }, { vertices = { { x, y }, ... } }, or a list of such.
std::vector<Contactor2> read_shape(const LuaCall& call, const Value& answer);

/// { points = { { x, y }, ... } [, parts = { name of each segment }] [, faces = { { toe = { x, y },
/// crest = { x, y } }, ... }] }. Without parts the terrain is one part without a name.
Profile read_terrain(const LuaCall& call, const Value& answer);

/// A list of { shape = as above [, position = { x, y }] [, angle = rad] }; radius or vertices may stand in
/// the place of shape. What is left out comes from the group.
std::vector<RockPlan> read_rocks(const LuaCall& call, const Value& answer);

/// { velocity = { vx, vy[, vz] } [, spin = w, a vector in 3D] [, note = text for the run's warnings] [,
/// greatest_throw = m] }.
Launch read_launch(const LuaCall& call, const Value& answer, int dimension);

}  // namespace flyrock
