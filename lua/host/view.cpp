#include "host/view.h"

#include <fmt/format.h>

#include <lua.hpp>

#include "host/table_reader.h"
#include "sandbox/read_only.h"
#include "sandbox/state.h"

namespace flyrock {

View::View(lua_State* lua, const ViewType& type,
           const std::vector<std::pair<std::string_view, int>>& fields) {
  box_ = static_cast<Box*>(lua_newuserdatauv(lua, sizeof(Box), 0));
  *box_ = {&type, nullptr};
  lua_createtable(lua, 0, 3);
  lua_createtable(lua, 0, static_cast<int>(fields.size()));
  for (const auto& [name, number] : fields) {
    lua_pushlstring(lua, name.data(), name.size());
    lua_pushinteger(lua, number);
    lua_rawset(lua, -3);
  }
  lua_pushvalue(lua, -1);
  lua_createtable(lua, 0, 0);  // the tables of vectors
  lua_pushcclosure(lua, guarded<View::index>, 2);
  lua_setfield(lua, -3, "__index");
  lua_pushcclosure(lua, guarded<View::new_index>, 1);
  lua_setfield(lua, -2, "__newindex");
  lua_pushboolean(lua, 0);
  lua_setfield(lua, -2, "__metatable");
  lua_setmetatable(lua, -2);
  reference_ = luaL_ref(lua, LUA_REGISTRYINDEX);
}

void View::push(lua_State* lua, const void* object) {
  box_->object = object;
  lua_rawgeti(lua, LUA_REGISTRYINDEX, reference_);
}

void View::push(lua_State* lua, int reference, const void* object) {
  lua_rawgeti(lua, LUA_REGISTRYINDEX, reference);
  static_cast<Box*>(lua_touserdata(lua, -1))->object = object;
}

/// The number of the field with the key at index 2.
int View::field(lua_State* lua, const Box& box) {
  lua_pushvalue(lua, 2);
  if (lua_rawget(lua, lua_upvalueindex(1)) == LUA_TNUMBER) {
    const auto number = static_cast<int>(lua_tointeger(lua, -1));
    lua_pop(lua, 1);
    return number;
  }
  const std::string name = lua_type(lua, 2) == LUA_TSTRING ? lua_tostring(lua, 2) : luaL_typename(lua, 2);
  raise(lua, fmt::format("`{}` has no field `{}`{}", box.type->name, name,
                         did_you_mean(name, text_keys(lua, lua_upvalueindex(1)))));
}

int View::index(lua_State* lua) {
  const Box& box = *static_cast<Box*>(lua_touserdata(lua, 1));
  const int number = field(lua, box);
  const ShownVector shown = box.type->vector ? box.type->vector(box.object, number) : ShownVector{};
  if (shown.vector)
    push_kept_vector(lua, box, number, shown);
  else
    box.type->push(lua, box.object, number);
  return 1;
}

/// Pushes the table of a vector, by its number from the tables in upvalue 2.
void View::push_kept_vector(lua_State* lua, const Box& box, int field, const ShownVector& shown) {
  if (lua_rawgeti(lua, lua_upvalueindex(2), field) == LUA_TNIL) {
    lua_pop(lua, 1);
    lua_createtable(lua, shown.dimension, 0);
    make_read_only(lua, fmt::format("{}.{}", box.type->name, lua_tostring(lua, 2)), true);
    lua_pushvalue(lua, -1);
    lua_rawseti(lua, lua_upvalueindex(2), field);
  }
  push_shown(lua, -1);
  for (int i = 0; i < 3; ++i) {
    if (i < shown.dimension)
      lua_pushnumber(lua, (*shown.vector)[i]);
    else
      lua_pushnil(lua);
    lua_rawseti(lua, -2, i + 1);
  }
  lua_pop(lua, 1);
}

int View::new_index(lua_State* lua) {
  const Box& box = *static_cast<Box*>(lua_touserdata(lua, 1));
  if (!box.type->assign) raise(lua, fmt::format("`{}` cannot be changed", box.type->name));
  box.type->assign(lua, box.object, field(lua, box));
  return 0;
}

const void* viewed(lua_State* lua, int index, const ViewType& type) {
  const auto* box = static_cast<const View::Box*>(lua_touserdata(lua, index));  // all userdata here are boxes
  if (!box || box->type != &type)
    raise(lua, fmt::format("a method of `{0}` was called without it: write {0}:method(...)", type.name));
  return box->object;
}

}  // namespace flyrock
