#include "host/view.h"

#include <fmt/format.h>

#include <lua.hpp>

#include "host/read_only.h"
#include "host/state.h"
#include "host/table_reader.h"

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
  lua_pushcclosure(lua, guarded<View::index>, 1);
  lua_setfield(lua, -2, "__index");
  lua_pushcfunction(lua, guarded<View::refuse_write>);
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

int View::index(lua_State* lua) {
  const Box& box = *static_cast<Box*>(lua_touserdata(lua, 1));
  lua_pushvalue(lua, 2);
  if (lua_rawget(lua, lua_upvalueindex(1)) == LUA_TNUMBER) {
    box.type->push(lua, box.object, static_cast<int>(lua_tointeger(lua, -1)));
    return 1;
  }
  const std::string field = lua_type(lua, 2) == LUA_TSTRING ? lua_tostring(lua, 2) : luaL_typename(lua, 2);
  raise(lua, fmt::format("`{}` has no field `{}`{}", box.type->name, field,
                         did_you_mean(field, text_keys(lua, lua_upvalueindex(1)))));
}

int View::refuse_write(lua_State* lua) {
  raise(lua, fmt::format("`{}` cannot be changed", static_cast<Box*>(lua_touserdata(lua, 1))->type->name));
}

const void* viewed(lua_State* lua, int index, const ViewType& type) {
  const auto* box = static_cast<const View::Box*>(lua_touserdata(lua, index));  // all our userdata are boxes
  if (!box || box->type != &type)
    raise(lua, fmt::format("a method of `{0}` was called without it: write {0}:method(...)", type.name));
  return box->object;
}

}  // namespace flyrock
