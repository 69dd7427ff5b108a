#include "host/read_only.h"

#include <fmt/format.h>

#include <algorithm>
#include <lua.hpp>
#include <vector>

#include "host/ordered_pairs.h"
#include "host/state.h"
#include "units/units.h"

namespace flyrock {

namespace {

int refuse_write(lua_State* lua) {
  raise(lua, fmt::format("`{}` cannot be changed", lua_tostring(lua, lua_upvalueindex(1))));
}

int length(lua_State* lua) {
  lua_pushinteger(lua, static_cast<lua_Integer>(lua_rawlen(lua, lua_upvalueindex(1))));
  return 1;
}

int pairs_of_view(lua_State* lua) {
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_replace(lua, 1);
  lua_settop(lua, 1);
  return ordered_pairs(lua);
}

int refuse_absent(lua_State* lua) {
  if (lua_type(lua, 2) != LUA_TSTRING)
    raise(lua, fmt::format("`{}` has no such field: a {}", lua_tostring(lua, lua_upvalueindex(1)),
                           luaL_typename(lua, 2)));
  lua_pushvalue(lua, 2);
  if (lua_rawget(lua, lua_upvalueindex(3)) != LUA_TNIL) {
    lua_pushnil(lua);
    return 1;
  }
  const std::string field = lua_tostring(lua, 2);
  const std::string nearest = nearest_name(field, text_keys(lua, lua_upvalueindex(2)));
  raise(lua, fmt::format("`{}` has no field `{}`{}", lua_tostring(lua, lua_upvalueindex(1)), field,
                         nearest.empty() ? "" : fmt::format(", did you mean `{}`?", nearest)));
}

}  // namespace

void make_read_only(lua_State* lua, const std::string& what, bool is_data) {
  const int table = lua_gettop(lua);
  lua_createtable(lua, 0, 0);  // the view stays empty, so that each access asks its metatable
  lua_createtable(lua, 0, 6);
  lua_pushvalue(lua, table);
  lua_setfield(lua, -2, "__index");
  lua_pushlstring(lua, what.data(), what.size());
  lua_pushcclosure(lua, refuse_write, 1);
  lua_setfield(lua, -2, "__newindex");
  lua_pushvalue(lua, table);
  lua_pushcclosure(lua, length, 1);
  lua_setfield(lua, -2, "__len");
  lua_pushvalue(lua, table);
  lua_pushcclosure(lua, guarded<pairs_of_view>, 1);
  lua_setfield(lua, -2, "__pairs");
  lua_pushboolean(lua, 0);
  lua_setfield(lua, -2, "__metatable");
  lua_pushboolean(lua, is_data);
  lua_setfield(lua, -2, "__data");
  lua_setmetatable(lua, -2);
  lua_replace(lua, table);
}

bool see_through(lua_State* lua) {
  const int view = lua_gettop(lua);
  if (luaL_getmetafield(lua, view, "__data") == LUA_TNIL) return true;
  const bool is_data = lua_toboolean(lua, -1);
  luaL_getmetafield(lua, view, "__index");
  lua_replace(lua, view);
  lua_settop(lua, view);
  return is_data;
}

void make_strict(lua_State* lua, int index, const std::string& what) {
  index = lua_absindex(lua, index);
  const int absent = lua_gettop(lua);
  lua_createtable(lua, 0, 1);
  lua_pushlstring(lua, what.data(), what.size());
  lua_pushvalue(lua, index);
  lua_pushvalue(lua, absent);
  lua_pushcclosure(lua, guarded<refuse_absent>, 3);
  lua_setfield(lua, -2, "__index");
  lua_setmetatable(lua, index);
  lua_settop(lua, absent - 1);
}

std::vector<std::string> text_keys(lua_State* lua, int index) {
  index = lua_absindex(lua, index);
  std::vector<std::string> keys;
  for (lua_pushnil(lua); lua_next(lua, index); lua_pop(lua, 1))
    if (lua_type(lua, -2) == LUA_TSTRING) keys.emplace_back(lua_tostring(lua, -2));
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace flyrock
