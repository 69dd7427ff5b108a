#include "sandbox/read_only.h"

#include <fmt/format.h>

#include <algorithm>
#include <lua.hpp>
#include <vector>

#include "sandbox/left_out.h"
#include "sandbox/ordered_pairs.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

int refuse_write(lua_State* lua) {
  raise(lua, fmt::format("`{}` cannot be changed", lua_tostring(lua, lua_upvalueindex(1))));
}

// Keys of metatables. Lua code cannot name them.
const char shown_key = 0;   // in a view: the table that it shows
const char data_key = 0;    // in a view: it is a view of data
const char view_key = 0;    // in the fields of a frozen table: its view
const char former_key = 0;  // in the view of a frozen table: the former metatable of the table

bool push_marked(lua_State* lua, int index, const char* key) {
  if (!lua_istable(lua, index) || !lua_getmetatable(lua, index)) return false;
  const bool marked = lua_rawgetp(lua, -1, key) != LUA_TNIL;
  lua_remove(lua, -2);
  if (!marked) lua_pop(lua, 1);
  return marked;
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
  const std::string full = std::string(lua_tostring(lua, lua_upvalueindex(1))) + '.' + field;
  if (const std::string_view instead = instead_of(full); !instead.empty())
    raise(lua, fmt::format("`{}` is not available here: {}", full, instead));
  raise(lua, fmt::format("`{}` has no field `{}`{}", lua_tostring(lua, lua_upvalueindex(1)), field,
                         budget_of(lua).wording.did_you_mean(field, text_keys(lua, lua_upvalueindex(2)))));
}

/// Pushes the metatable of a view of the table at `shown`.
void push_view_metatable(lua_State* lua, int shown, const std::string& what, lua_CFunction refuse,
                         bool is_data) {
  lua_createtable(lua, 0, 7);
  lua_pushvalue(lua, shown);
  lua_setfield(lua, -2, "__index");
  lua_pushlstring(lua, what.data(), what.size());
  lua_pushcclosure(lua, refuse, 1);
  lua_setfield(lua, -2, "__newindex");
  lua_pushvalue(lua, shown);
  lua_pushcclosure(lua, length, 1);
  lua_setfield(lua, -2, "__len");
  lua_pushvalue(lua, shown);
  lua_pushcclosure(lua, guarded<pairs_of_view>, 1);
  lua_setfield(lua, -2, "__pairs");
  lua_pushboolean(lua, 0);
  lua_setfield(lua, -2, "__metatable");
  lua_pushvalue(lua, shown);
  lua_rawsetp(lua, -2, &shown_key);
  if (is_data) {
    lua_pushboolean(lua, 1);
    lua_rawsetp(lua, -2, &data_key);
  }
}

/// Moves all fields of one table into another.
void move_fields(lua_State* lua, int from, int to) {
  for (lua_pushnil(lua); lua_next(lua, from);) {
    lua_pushvalue(lua, -2);
    lua_insert(lua, -2);
    lua_rawset(lua, to);
  }
  for (lua_pushnil(lua); lua_next(lua, to); lua_pop(lua, 1)) {
    lua_pushvalue(lua, -2);
    lua_pushnil(lua);
    lua_rawset(lua, from);
  }
}

/// __index of a frozen table whose own __index is a function (upvalue 2). Its fields (upvalue 1) come first.
int index_by_function(lua_State* lua) {
  lua_pushvalue(lua, 2);
  if (lua_rawget(lua, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  lua_pushvalue(lua, lua_upvalueindex(2));
  lua_pushvalue(lua, 1);
  lua_pushvalue(lua, 2);
  lua_call(lua, 2, 1);
  return 1;
}

/// On the stack: the fields of a frozen table at `fields`, the metatable of its view, the metatable of its
/// fields, and its former metatable, which is popped.
void keep_metamethods(lua_State* lua, int fields) {
  const int of_view = fields + 1, of_fields = fields + 2, own = fields + 3;
  lua_pushvalue(lua, own);  // the answer of getmetatable, unless it has its own
  lua_setfield(lua, of_view, "__metatable");
  if (push_shown(lua, own)) lua_replace(lua, own);
  for (lua_pushnil(lua); lua_next(lua, own); lua_pop(lua, 1)) {
    const std::string_view name = lua_type(lua, -2) == LUA_TSTRING ? lua_tostring(lua, -2) : "";
    // setmetatable refuses the fields that act at garbage collection. If they are set later, they have no
    // effect.
    if (name == "__newindex" || name == "__mode" || name == "__gc" || !name.starts_with("__")) continue;
    int to = of_view;
    lua_pushvalue(lua, -1);
    if (name == "__index" && lua_isfunction(lua, -1)) {
      lua_pushvalue(lua, fields);
      lua_insert(lua, -2);
      lua_pushcclosure(lua, index_by_function, 2);
    } else if (name == "__index") {
      to = of_fields;  // Lua code never sees these fields, so only a table may follow them
    }
    lua_setfield(lua, to, name.data());
  }
  lua_pop(lua, 1);
}

}  // namespace

void make_read_only(lua_State* lua, const std::string& what, bool is_data) {
  const int table = lua_gettop(lua);
  lua_createtable(lua, 0, 0);  // empty, so that each access uses its metatable
  push_view_metatable(lua, table, what, refuse_write, is_data);
  lua_setmetatable(lua, -2);
  lua_replace(lua, table);
}

void freeze_table(lua_State* lua, int index, const std::string& what, lua_CFunction refuse) {
  index = lua_absindex(lua, index);
  lua_createtable(lua, 0, 0);
  const int fields = lua_gettop(lua);
  move_fields(lua, index, fields);
  push_view_metatable(lua, fields, what, refuse, true);
  lua_createtable(lua, 0, 2);  // of the fields: leads back to the view, and inherits
  lua_pushvalue(lua, index);
  lua_rawsetp(lua, -2, &view_key);
  if (lua_getmetatable(lua, index)) keep_metamethods(lua, fields);
  lua_setmetatable(lua, fields);
  lua_setmetatable(lua, index);
  lua_settop(lua, fields - 1);
}

void keep_former_metatable(lua_State* lua, int index) {
  lua_getmetatable(lua, index);
  lua_insert(lua, -2);
  lua_rawsetp(lua, -2, &former_key);
  lua_pop(lua, 1);
}

bool push_former_metatable(lua_State* lua, int index) { return push_marked(lua, index, &former_key); }

void mark_hidden(lua_State* lua, int index) {
  index = lua_absindex(lua, index);
  lua_getmetatable(lua, index);
  lua_pushvalue(lua, index);
  lua_rawsetp(lua, -2, &shown_key);
  lua_pop(lua, 1);
}

bool push_shown(lua_State* lua, int index) { return push_marked(lua, index, &shown_key); }
bool push_view(lua_State* lua, int index) { return push_marked(lua, index, &view_key); }

bool see_through(lua_State* lua) {
  if (!push_shown(lua, -1)) return true;
  lua_getmetatable(lua, -2);
  const bool is_data = lua_rawgetp(lua, -1, &data_key) != LUA_TNIL;
  lua_pop(lua, 2);
  lua_replace(lua, -2);
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
