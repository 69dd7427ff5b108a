#pragma once
// Converts the tables that plugins return into the engine's types. A wrong answer is a PluginError that names
// the field: "plugin my_shape, my_shape.lua:9: build() returned vertices[1] = text, expected { x, y }".

#include "document/value.h"
#include "host/lua_call.h"
#include "plugin/models.h"

namespace flyrock {

/// The result at the top of the stack, as a tree.
Value answer_tree(const LuaCall& call, lua_State* lua);

/// Reads a contactor { radius = r [, centre = { x, y }] } or { vertices = { { x, y }, ... } }, in 3D
/// { radius = r [, centre = { x, y, z }] } or { points = { { x, y, z }, ... } } (their hull); two vertices or
/// points with a radius are a wall or a pill; a list of these, or { contactors = one or a list [, mass = kg]
/// [, inertia = kg m2 (3D: a tensor in rows)] [, centre]
/// }. Throws DimensionError for a field of the other dimension. Instantiated for D = 2, 3.
template <int D>
ShapeAnswer<D> read_shape(const LuaCall& call, const Value& answer);

/// Reads { points = { { x, y }, ... } [, parts = { name of each segment }] [, faces = { { toe = { x, y },
/// crest = { x, y } }, ... }] }. Without parts, the terrain is one part without a name.
Profile read_terrain(const LuaCall& call, const Value& answer);

/// The same in 3D: { vertices = { { x, y, z }, ... }, triangles = { { a, b, c }, ... } [, part = { of each
/// triangle }, parts = { name, ... }] [, faces = { { name =, toe = { { x, y, z }, ... }, crest = { ... } },
/// ... }] } with indices from 1, or { heights = { row, ... }, cell = m [, corner = { x, y }] }: rows from the
/// south, each from the west, `corner` the place of the first height; `false` has no data.
TerrainShape3 read_terrain_3d(const LuaCall& call, const Value& answer);

/// Refuses an answer with one of `keys`, which belong to a terrain of `dimension`, where the scenario has the
/// other one. Throws DimensionError, because a terrain may serve one dimension only.
void refuse_dimension(const LuaCall& call, const Value& answer, const std::vector<std::string>& keys,
                      int dimension, const std::string& expected);

/// Reads a list of rocks, whose fields may all be left out. In 2D { shape = as above, or radius or vertices
/// in its place, position = { x, y }, angle = rad, velocity = { vx, vy }, spin = rad/s }. In 3D { shape = as
/// above, or radius or points in its place, position, orientation = { axis =, angle = } or a quaternion { w,
/// x, y, z }, velocity, spin as vectors }. In both density or mass, material. Instantiated for D = 2, 3.
template <int D>
std::vector<RockPlan<D>> read_rocks(const LuaCall& call, const Value& answer);

/// Reads { velocity = { vx, vy[, vz] } [, spin = w, a vector in 3D] [, note = text for the run's warnings] [,
/// greatest_throw = m] }.
Launch read_launch(const LuaCall& call, const Value& answer, int dimension);

}  // namespace flyrock
