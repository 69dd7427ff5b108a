#include "host/lua_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <lua.hpp>

#include "sandbox/read_only.h"

namespace flyrock {

LuaParameters::LuaParameters(lua_State* lua, const PluginSpec& spec, Params& params) {
  lua_createtable(lua, 0, static_cast<int>(spec.params.size()));
  const int whole = lua_gettop(lua);
  lua_createtable(lua, 0, 0);  // no names may be absent
  // The table of the group of the present parameter: its place on the stack and its reference; 0: none.
  int group_table = 0, group_reference = 0;
  std::string group;
  const auto close_group = [&] {
    if (group_table == 0) return;
    lua_createtable(lua, 0, 0);
    for (const ParamSpec& param : spec.params)
      if (param.group() == group && !params.given(param.name)) {
        lua_pushboolean(lua, 1);
        lua_setfield(lua, -2, std::string(param.own_name()).c_str());
      }
    make_strict(lua, group_table, "p." + group);
    make_read_only(lua, "p." + group);
    lua_setfield(lua, whole, group.c_str());
    group_table = group_reference = 0;
  };
  for (const ParamSpec& param : spec.params) {
    const bool given = params.given(param.name);
    const std::string name(param.own_name());
    if (group != param.group()) {
      close_group();
      group = param.group();
    }
    if (!given) {
      lua_pushboolean(lua, 1);
      lua_setfield(lua, whole + 1, (group.empty() ? name : group).c_str());
    }
    if (given && !group.empty() && group_table == 0) {
      lua_createtable(lua, 0, 0);
      group_table = lua_gettop(lua);
      lua_pushvalue(lua, group_table);
      group_reference = luaL_ref(lua, LUA_REGISTRYINDEX);
      vectors_.push_back(group_reference);
    }
    const int table = group_table == 0 ? whole : group_table;
    const bool components =
        param.type == ParamType::vector || (param.type == ParamType::spin && params.dimension() == 3);
    switch (components ? ParamType::vector : param.type) {
      case ParamType::number:
      case ParamType::integer:
      case ParamType::boolean:
      case ParamType::spin:
        if (const int slot = params.slot(param.name); slot >= 0)
          fields_.push_back({name, param.type, slot, 0, group_reference});
        break;
      case ParamType::vector:
        if (const int slot =
                param.type == ParamType::spin ? params.slot(param.name) : params.vector_slot(param.name);
            slot >= 0) {
          lua_createtable(lua, params.dimension(), 0);
          lua_pushvalue(lua, -1);
          const int list = luaL_ref(lua, LUA_REGISTRYINDEX);
          vectors_.push_back(list);
          make_read_only(lua, "p." + param.name, true);
          lua_setfield(lua, table, name.c_str());
          for (int i = 0; i < params.dimension(); ++i)
            fields_.push_back({name, param.type, slot + i, i + 1, list});
        }
        break;
      case ParamType::choice:
      case ParamType::text:
      case ParamType::file:
        if (const std::string text = params.text(param.name); given) {
          lua_pushlstring(lua, text.data(), text.size());
          lua_setfield(lua, table, name.c_str());
        }
        break;
      case ParamType::points:
      case ParamType::plan_points: {
        const auto& points = params.points(param.name);
        if (!given) break;
        lua_createtable(lua, static_cast<int>(points.size()), 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
          lua_createtable(lua, static_cast<int>(points[i].size()), 0);
          for (std::size_t k = 0; k < points[i].size(); ++k) {
            lua_pushnumber(lua, points[i][k]);
            lua_rawseti(lua, -2, static_cast<lua_Integer>(k + 1));
          }
          make_read_only(lua, "p." + param.name, true);
          lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
        }
        make_read_only(lua, "p." + param.name, true);
        lua_setfield(lua, table, name.c_str());
        break;
      }
      case ParamType::shapes:
      case ParamType::records:
      case ParamType::law:
        break;  // of native plugins only (manifest.cpp)
    }
  }
  close_group();
  make_strict(lua, whole, "p");
  lua_pushvalue(lua, whole);
  table_ = luaL_ref(lua, LUA_REGISTRYINDEX);
  make_read_only(lua, "p");
  view_ = luaL_ref(lua, LUA_REGISTRYINDEX);
}

namespace {
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
}  // namespace

void LuaParameters::push(lua_State* lua, Values values) {
  const bool first = last_.size() != values.size();
  if (first || !std::equal(values.begin(), values.end(), last_.begin(), same_bits)) {
    for (const Field& field : fields_)
      if (first || !same_bits(last_[field.slot], values[field.slot])) set(lua, field, values[field.slot]);
    last_.assign(values.begin(), values.end());
  }
  lua_rawgeti(lua, LUA_REGISTRYINDEX, view_);
}

void LuaParameters::set(lua_State* lua, const Field& field, double value) {
  lua_rawgeti(lua, LUA_REGISTRYINDEX, field.inner ? field.inner : table_);
  if (field.type == ParamType::boolean)
    lua_pushboolean(lua, value != 0);
  else if (field.type == ParamType::integer)
    lua_pushinteger(lua, static_cast<lua_Integer>(value));
  else
    lua_pushnumber(lua, value);
  if (field.component)
    lua_rawseti(lua, -2, field.component);
  else
    lua_setfield(lua, -2, field.name.c_str());
  lua_pop(lua, 1);
}

std::vector<int> LuaParameters::references() const {
  std::vector<int> all = vectors_;
  all.insert(all.end(), {table_, view_});
  return all;
}

LuaCall::LuaCall(std::shared_ptr<const LuaPlugin> plugin, Params& params,
                 std::vector<View> (*make_views)(lua_State*, const PluginSpec&), double instructions)
    : plugin_(std::move(plugin)), instructions_(instructions), dimension_(params.dimension()) {
  try {
    plugin_->state->run(Budget::load_limit, [&](lua_State* lua) {
      parameters_ = std::make_unique<LuaParameters>(lua, plugin_->spec, params);
      views_ = make_views(lua, plugin_->spec);
      lua_rawgeti(lua, LUA_REGISTRYINDEX, plugin_->function);
      outer_ = std::make_unique<OuterLocals>(lua, plugin_->entry);
    });
  } catch (const LuaError& error) {
    rethrow(error);
  }
}

LuaCall::~LuaCall() {
  for (const int reference : parameters_->references()) plugin_->state->release(reference);
  for (const View& view : views_) plugin_->state->release(view.reference());
  plugin_->state->release(outer_->reference());
}

void LuaCall::call(lua_State* lua, Values values, std::initializer_list<const void*> objects,
                   int results) const {
  lua_rawgeti(lua, LUA_REGISTRYINDEX, plugin_->function);
  parameters_->push(lua, values);
  auto view = views_.begin();
  for (const void* object : objects) (view++)->push(lua, object);
  const bool is_build = plugin_->entry == "build";
  if (is_build) lua_pushinteger(lua, dimension_);
  lua_call(lua, 1 + static_cast<int>(objects.size()) + is_build, results);
  if (const char* changed = outer_->restore(lua))
    fail(fmt::format(
        "changed `{}`, a local variable outside of it: a plugin keeps nothing from call to call, so that "
        "every run is the same",
        changed));
}

void LuaCall::end_failed(const LuaError& error) const {
  plugin_->state->run(instructions_, [&](lua_State* lua) {
    outer_->restore(lua);
    // Collects the garbage of the call. Otherwise it would count in later calls, and their messages would
    // depend on the earlier rocks of this thread.
    lua_gc(lua, LUA_GCCOLLECT);
  });
  rethrow(error);
}

void LuaCall::rethrow(const LuaError& error) const {
  const std::string text = error.what();
  if (has_place(text)) throw PluginError(fmt::format("plugin {}, {}", plugin_->spec.name, text));
  throw PluginError(fmt::format("plugin {}: {}() {}", plugin_->origin, plugin_->entry, text));
}

void LuaCall::fail(const std::string& text) const {
  throw PluginError(fmt::format("plugin {}: {}() {}", plugin_->origin, plugin_->entry, text));
}

double LuaCall::number(lua_State* lua, int index, const char* name) const {
  if (lua_type(lua, index) != LUA_TNUMBER)
    fail(fmt::format("returned {} for {}, expected a number", luaL_typename(lua, index), name));
  return lua_tonumber(lua, index);
}

}  // namespace flyrock
