// The basic functions and coroutines of the sandbox.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <lua.hpp>
#include <string>

#include "sandbox/ordered_pairs.h"
#include "sandbox/read_only.h"
#include "sandbox/sandbox.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

/// The end of pcall and xpcall, also after the call has yielded. `kept` values at the bottom are not results.
int finish_call(lua_State* lua, int status, lua_KContext kept) {
  if (status != LUA_OK && status != LUA_YIELD) {
    raise_if_exceeded(lua);
    lua_pushboolean(lua, 0);
    lua_pushvalue(lua, -2);
    return 2;
  }
  return lua_gettop(lua) - static_cast<int>(kept);
}

int protected_call(lua_State* lua) {
  luaL_checkany(lua, 1);
  lua_pushboolean(lua, 1);  // the first result
  lua_insert(lua, 1);
  return finish_call(lua, lua_pcallk(lua, lua_gettop(lua) - 2, LUA_MULTRET, 0, 0, finish_call), 0);
}

/// Calls the handler in upvalue 1, unless the budget is exceeded. In that case Lua calls handlers inside the
/// hook that raised the error, where no hook counts their instructions.
int call_handler(lua_State* lua) {
  if (!budget_of(lua).exceeded.empty()) return 1;
  lua_settop(lua, 1);
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_insert(lua, 1);
  lua_call(lua, 1, 1);
  return 1;
}

int protected_call_with_handler(lua_State* lua) {
  const int arguments = lua_gettop(lua) - 2;
  luaL_checktype(lua, 2, LUA_TFUNCTION);
  lua_pushvalue(lua, 2);
  lua_pushcclosure(lua, call_handler, 1);
  lua_replace(lua, 2);
  lua_pushboolean(lua, 1);
  lua_pushvalue(lua, 1);
  lua_rotate(lua, 3, 2);  // function, handler, true, function, arguments
  return finish_call(lua, lua_pcallk(lua, arguments, LUA_MULTRET, 2, 2, finish_call), 2);
}

int set_metatable(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  luaL_argexpected(lua, lua_isnoneornil(lua, 2) || lua_istable(lua, 2), 2, "nil or table");
  if (luaL_getmetafield(lua, 1, "__metatable") != LUA_TNIL)
    raise(lua, "this table is protected: it keeps its metatable");
  if (push_shown(lua, 2)) {
    if (push_view(lua, -1)) lua_copy(lua, -2, 2);
    lua_settop(lua, 2);
  }
  if (lua_istable(lua, 2))
    for (const char* name :
         {"__gc", "__mode"}) {  // both act at garbage collection, whose moment differs from run to run
      lua_pushstring(lua, name);
      if (lua_rawget(lua, 2) != LUA_TNIL)
        raise(lua, fmt::format("the metamethod {} is not available here", name));
    }
  lua_settop(lua, 2);
  lua_setmetatable(lua, 1);
  return 1;
}

int get_metatable(lua_State* lua) {
  luaL_checkany(lua, 1);
  if (luaL_getmetafield(lua, 1, "__metatable") != LUA_TNIL) return 1;
  if (!lua_getmetatable(lua, 1)) lua_pushnil(lua);
  push_view(lua, -1);
  return 1;
}

/// Lets rawget and rawlen see the fields of a view. Upvalue 1 is the original function.
int raw_access(lua_State* lua) {
  if (push_shown(lua, 1)) lua_replace(lua, 1);
  return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

/// tostring without addresses.
int to_text(lua_State* lua) {
  luaL_checkany(lua, 1);
  switch (lua_type(lua, 1)) {
    case LUA_TNUMBER:
    case LUA_TSTRING:
    case LUA_TBOOLEAN:
    case LUA_TNIL:
      break;
    default:
      if (luaL_getmetafield(lua, 1, "__tostring") != LUA_TNIL) break;
      lua_pushstring(lua, luaL_typename(lua, 1));
      return 1;
  }
  luaL_tolstring(lua, 1, nullptr);
  return 1;
}

/// Prints to stderr, because stdout is for results, or into the log if the host collects prints.
int print(lua_State* lua) {
  const int count = lua_gettop(lua);
  std::string text;
  for (int i = 1; i <= count; ++i) {
    lua_pushcfunction(lua, to_text);
    lua_pushvalue(lua, i);
    lua_call(lua, 1, 1);
    std::size_t length;
    const char* one = lua_tolstring(lua, -1, &length);
    charge(lua, 10 + static_cast<double>(length) / Budget::bytes_per_instruction);
    constexpr std::size_t enough = 1 << 16;  // more is never shown
    if (i > 1) text += '\t';
    if (text.size() < enough) text.append(one, std::min(length, enough));
    lua_pop(lua, 1);
  }
  std::string place = place_of(lua);
  if (place.ends_with(": ")) place.resize(place.size() - 2);
  Budget& budget = budget_of(lua);
  budget.prints.add(place, text, budget.wording.printable);
  if (budget.shows_prints)
    for (const std::string& line : budget.prints.take()) std::fprintf(stderr, "%s\n", line.c_str());
  return 0;
}

/// Charges for the state of a coroutine, because each coroutine starts its own count of instructions.
void charge_coroutine(lua_State* lua) { charge(lua, 10 * Budget::interval); }

int create_coroutine(lua_State* lua) {
  charge_coroutine(lua);
  return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

int resume(lua_State* lua) {
  const int results = lua_tocfunction(lua, lua_upvalueindex(1))(lua);
  if (!lua_toboolean(lua, -results)) raise_if_exceeded(lua);
  return results;
}

/// Refused if the budget is exceeded: when a coroutine died inside the hook, no hook counts the instructions
/// of its __close methods.
int close(lua_State* lua) {
  if (const std::string& exceeded = budget_of(lua).exceeded; !exceeded.empty()) exceed(lua, exceeded);
  return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

/// The function that coroutine.wrap returns. Upvalues: resume, the coroutine, close.
int resume_wrapped(lua_State* lua) {
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_pushvalue(lua, lua_upvalueindex(2));
  lua_rotate(lua, 1, 2);
  lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
  if (lua_toboolean(lua, 1)) return lua_gettop(lua) - 1;
  const int status = lua_status(lua_tothread(lua, lua_upvalueindex(2)));
  if (status != LUA_OK && status != LUA_YIELD) {  // it failed, in its code or while its variables were closed
    lua_pushvalue(lua, lua_upvalueindex(3));
    lua_pushvalue(lua, lua_upvalueindex(2));
    lua_call(lua, 1, 2);
  }
  if (lua_type(lua, -1) == LUA_TSTRING) {
    luaL_where(lua, 1);
    lua_insert(lua, -2);
    lua_concat(lua, 2);
  }
  return lua_error(lua);
}

/// Upvalues: create, resume, close.
int wrap(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TFUNCTION);
  lua_settop(lua, 1);
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_insert(lua, 1);
  lua_call(lua, 1, 1);
  lua_pushvalue(lua, lua_upvalueindex(2));
  lua_insert(lua, 1);
  lua_pushvalue(lua, lua_upvalueindex(3));
  lua_pushcclosure(lua, resume_wrapped, 3);
  return 1;
}

void wrap_original(lua_State* lua, const char* name, lua_CFunction wrapper) {
  lua_getfield(lua, -1, name);
  lua_pushcclosure(lua, wrapper, 1);
  lua_setfield(lua, -2, name);
}

}  // namespace

void add_base_library(lua_State* lua) {
  lua_pushcfunction(lua,
                    luaopen_base);  // fills the state's own table of globals, which no sandboxed code sees
  lua_call(lua, 0, 1);
  for (const char* name : {"assert", "error", "ipairs", "rawequal", "rawget", "rawlen", "select", "tonumber",
                           "type", "_VERSION"}) {
    lua_getfield(lua, -1, name);
    lua_setfield(lua, -3, name);
  }
  lua_pop(lua, 1);
  constexpr luaL_Reg own[] = {{"next", guarded<ordered_next>},
                              {"pairs", guarded<ordered_pairs>},
                              {"pcall", protected_call},
                              {"xpcall", protected_call_with_handler},
                              {"setmetatable", guarded<set_metatable>},
                              {"getmetatable", get_metatable},
                              {"tostring", to_text},
                              {"print", guarded<print>},
                              {nullptr, nullptr}};
  luaL_setfuncs(lua, own, 0);
  for (const char* name : {"rawget", "rawlen"}) wrap_original(lua, name, raw_access);
}

void add_coroutine_library(lua_State* lua) {
  wrap_original(lua, "create", create_coroutine);
  wrap_original(lua, "resume", resume);
  wrap_original(lua, "close", close);
  const int library = lua_gettop(lua);
  for (const char* name : {"create", "resume", "close"}) lua_getfield(lua, library, name);
  lua_pushcclosure(lua, wrap, 3);
  lua_setfield(lua, library, "wrap");
}

}  // namespace flyrock
