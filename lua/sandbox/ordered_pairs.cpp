#include "sandbox/ordered_pairs.h"

#include <algorithm>
#include <lua.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "sandbox/read_only.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

int rank(lua_State* lua, int index) {
  switch (lua_type(lua, index)) {
    case LUA_TNUMBER:
      return 0;
    case LUA_TSTRING:
      return 1;
    case LUA_TBOOLEAN:
      return 2;
    default:
      // Which of several such keys comes first depends on their addresses, so the message does not name their
      // types.
      raise(lua, "a table has no fixed order where a key is neither a number, a text nor a boolean");
  }
}

/// Whether the key at `a` comes before the key at `b`.
bool before(lua_State* lua, int a, int b) {
  const int rank_a = rank(lua, a), rank_b = rank(lua, b);
  if (rank_a != rank_b) return rank_a < rank_b;
  if (rank_a == 2) return lua_toboolean(lua, a) < lua_toboolean(lua, b);
  if (rank_a == 0) return lua_compare(lua, a, b, LUA_OPLT) != 0;
  std::size_t length_a, length_b;  // compared by bytes, not by the collation of the locale
  const char* text_a = lua_tolstring(lua, a, &length_a);
  const char* text_b = lua_tolstring(lua, b, &length_b);
  return std::string_view(text_a, length_a) < std::string_view(text_b, length_b);
}

/// Upvalues: the sorted list of keys, the index in it, the table. (The table is not the state of the loop,
/// because Lua code could then write the table of a read-only view.)
int next_of_list(lua_State* lua) {
  auto place = lua_tointeger(lua, lua_upvalueindex(2));
  for (;;) {
    lua_settop(lua, 0);
    if (lua_rawgeti(lua, lua_upvalueindex(1), ++place) == LUA_TNIL) return 1;
    lua_pushvalue(lua, -1);
    if (lua_rawget(lua, lua_upvalueindex(3)) != LUA_TNIL)
      break;  // skips a field that was removed during the loop
  }
  lua_pushinteger(lua, place);
  lua_replace(lua, lua_upvalueindex(2));
  return 2;
}

}  // namespace

int ordered_pairs(lua_State* lua) {
  luaL_checkany(lua, 1);
  if (luaL_getmetafield(lua, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(lua, 1);
    lua_call(lua, 1, 3);
    return 3;
  }
  luaL_checktype(lua, 1, LUA_TTABLE);
  lua_settop(lua, 1);

  struct Key {
    int rank;
    double number;  // orders numbers; `integer` orders integers above 2^53 that round to the same double
    lua_Integer integer;
    std::string text;
  };
  std::vector<Key> keys;
  for (lua_pushnil(lua); lua_next(lua, 1); lua_pop(lua, 1)) {
    Key key{rank(lua, -2), 0, 0, {}};
    if (key.rank == 0) {
      key.number = lua_tonumber(lua, -2);
      key.integer = lua_isinteger(lua, -2) ? lua_tointeger(lua, -2) : 0;
    } else if (key.rank == 1) {
      std::size_t length;
      const char* text = lua_tolstring(lua, -2, &length);
      key.text.assign(text, length);
    } else {
      key.number = lua_toboolean(lua, -2);
    }
    keys.push_back(std::move(key));
  }
  charge(lua, 8.0 * static_cast<double>(keys.size()));
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tie(a.rank, a.number, a.integer, a.text) < std::tie(b.rank, b.number, b.integer, b.text);
  });

  lua_createtable(lua, static_cast<int>(keys.size()), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Key& key = keys[i];
    if (key.rank == 1)
      lua_pushlstring(lua, key.text.data(), key.text.size());
    else if (key.rank == 2)
      lua_pushboolean(lua, key.number != 0);
    else if (key.number == static_cast<double>(key.integer))
      lua_pushinteger(lua, key.integer);
    else
      lua_pushnumber(lua, key.number);
    lua_rawseti(lua, 2, static_cast<lua_Integer>(i + 1));
  }
  lua_pushinteger(lua, 0);
  lua_pushvalue(lua, 1);
  lua_pushcclosure(lua, guarded<next_of_list>, 3);
  return 1;
}

int ordered_next(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  lua_settop(lua, 2);
  if (push_shown(lua, 1)) lua_replace(lua, 1);
  const bool first = lua_isnil(lua, 2);
  lua_pushnil(lua);  // 3: the best key so far
  double steps = 0;
  for (lua_pushnil(lua); lua_next(lua, 1); lua_pop(lua, 1)) {
    ++steps;
    const int key = lua_gettop(lua) - 1;
    if ((first || before(lua, 2, key)) && (lua_isnil(lua, 3) || before(lua, key, 3))) lua_copy(lua, key, 3);
  }
  charge(lua, steps);
  if (lua_isnil(lua, 3)) return 1;
  lua_pushvalue(lua, 3);
  lua_rawget(lua, 1);
  return 2;
}

}  // namespace flyrock
