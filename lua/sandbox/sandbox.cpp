#include "sandbox/sandbox.h"

#include <fmt/format.h>

#include <lua.hpp>

#include "sandbox/left_out.h"
#include "sandbox/read_only.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

int refuse_undefined(lua_State* lua) {
  const char* text = lua_tostring(lua, 2);
  const std::string name = text ? text : luaL_typename(lua, 2);
  if (const std::string_view instead = instead_of(name); !instead.empty())
    raise(lua, fmt::format("`{}` is not available here: {}", name, instead));
  raise(lua, fmt::format("`{}` is not defined{}", name,
                         budget_of(lua).wording.did_you_mean(name, text_keys(lua, lua_upvalueindex(1)))));
}

int refuse_global(lua_State* lua) {
  const char* name = lua_tostring(lua, 2);
  raise(lua, fmt::format("globals are frozen after loading: `{}` cannot be set, use a local variable",
                         name ? name : luaL_typename(lua, 2)));
}

/// Opens a Lua library without registering it.
void push_library(lua_State* lua, lua_CFunction open) {
  lua_pushcfunction(lua, open);
  lua_call(lua, 0, 1);
}

void add_read_only(lua_State* lua, const char* name) {
  lua_createtable(lua, 0, 0);
  make_strict(lua, -2, name);
  make_read_only(lua, name);
  lua_setfield(lua, -2, name);
}

}  // namespace

void push_globals(lua_State* lua) {
  lua_createtable(lua, 0, 40);
  add_base_library(lua);

  push_library(lua, luaopen_math);
  for (const char* name : {"random", "randomseed"}) {
    lua_pushnil(lua);
    lua_setfield(lua, -2, name);
  }
  add_read_only(lua, "math");
  push_library(lua, luaopen_table);
  add_table_library(lua);
  add_read_only(lua, "table");
  push_library(lua, luaopen_coroutine);
  add_coroutine_library(lua);
  add_read_only(lua, "coroutine");
  push_library(lua, luaopen_string);
  add_string_library(lua);
  add_read_only(lua, "string");

  lua_createtable(lua, 0, 1);  // metatable of the globals, for undefined names
  lua_pushvalue(lua, -2);
  lua_pushcclosure(lua, guarded<refuse_undefined>, 1);
  lua_setfield(lua, -2, "__index");
  lua_setmetatable(lua, -2);
  mark_hidden(lua, -1);
}

void push_environment(lua_State* lua, int globals) {
  globals = lua_absindex(lua, globals);
  lua_createtable(lua, 0, 0);
  lua_createtable(lua, 0, 2);
  lua_pushvalue(lua, globals);
  lua_setfield(lua, -2, "__index");
  lua_pushboolean(lua, 0);
  lua_setfield(lua, -2, "__metatable");
  lua_setmetatable(lua, -2);
}

void freeze_environment(lua_State* lua, int index) { freeze_table(lua, index, "", guarded<refuse_global>); }

}  // namespace flyrock
