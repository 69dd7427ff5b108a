// The functions of `table` and `string` that loop in C, where no hook counts. Each charges for its work
// first.

#include <fmt/format.h>

#include <algorithm>
#include <lua.hpp>
#include <string_view>

#include "sandbox/pattern.h"
#include "sandbox/sandbox.h"
#include "sandbox/stable_sort.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

/// The cost of a call in instructions, computed from its arguments. Errors in the arguments are left to the
/// original function.
using Cost = double (*)(lua_State*);

/// Charges, then calls the original function in upvalue 1.
template <Cost cost>
int charged(lua_State* lua) {
  charge(lua, cost(lua));
  return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

double texts(lua_State* lua) {
  double bytes = 0;
  for (int i = 1; i <= lua_gettop(lua); ++i)
    if (lua_type(lua, i) == LUA_TSTRING) bytes += static_cast<double>(lua_rawlen(lua, i));
  return bytes / Budget::bytes_per_instruction;
}

double repeat(lua_State* lua) {
  const double length = lua_isstring(lua, 1) ? static_cast<double>(lua_rawlen(lua, 1)) : 0;
  const double between = lua_isstring(lua, 3) ? static_cast<double>(lua_rawlen(lua, 3)) : 0;
  const double copies = std::max(0.0, lua_tonumber(lua, 2));
  if (copies * (length + between) > Budget::text_limit + between) exceed(lua, Budget::long_text);
  constexpr double copies_per_instruction = 64;
  return copies / copies_per_instruction;
}

double range(lua_State* lua, int first, int last, double length) {
  const double from = lua_isnoneornil(lua, first) ? 1 : lua_tonumber(lua, first);
  const double to = lua_isnoneornil(lua, last) ? length : lua_tonumber(lua, last);
  return std::max(0.0, to - from + 1);
}

/// The length as the library sees it. A metamethod __len may return any number.
double length_of(lua_State* lua) { return lua_istable(lua, 1) ? static_cast<double>(luaL_len(lua, 1)) : 0; }

double concatenate(lua_State* lua) { return range(lua, 3, 4, lua_isnoneornil(lua, 4) ? length_of(lua) : 0); }
double unpack(lua_State* lua) { return range(lua, 2, 3, lua_isnoneornil(lua, 3) ? length_of(lua) : 0); }
double move(lua_State* lua) { return range(lua, 2, 3, 0); }
double shift(lua_State* lua) { return std::max(0.0, length_of(lua)); }

template <Cost cost>
void bound(lua_State* lua, const char* name) {
  lua_getfield(lua, -1, name);
  lua_pushcclosure(lua, charged<cost>, 1);
  lua_setfield(lua, -2, name);
}

/// string.format without addresses: %p is refused and %s uses the sandbox's tostring. The pattern may contain
/// zero bytes.
int format(lua_State* lua) {
  charge(lua, texts(lua));
  std::size_t length;
  const char* text = luaL_checklstring(lua, 1, &length);
  const std::string_view pattern(text, length);
  int argument = 1;
  for (std::size_t at = pattern.find('%'); at != pattern.npos; at = pattern.find('%', at + 1)) {
    at = std::min(pattern.find_first_not_of("-+ #0.123456789", at + 1), pattern.size());
    const char conversion = at < pattern.size() ? pattern[at] : '\0';
    if (conversion == '%') continue;  // "%%", or a conversion that Lua refuses
    ++argument;
    if (conversion == 'p')
      raise(lua, "the format %p is not available here: addresses differ from run to run");
    const int type = lua_type(lua, argument);
    if (conversion == 's' && type > LUA_TBOOLEAN && type != LUA_TNUMBER && type != LUA_TSTRING) {
      lua_pushvalue(lua, lua_upvalueindex(2));
      lua_pushvalue(lua, argument);
      lua_call(lua, 1, 1);
      lua_replace(lua, argument);
    }
  }
  return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

}  // namespace

void add_table_library(lua_State* lua) {
  bound<concatenate>(lua, "concat");
  bound<unpack>(lua, "unpack");
  bound<move>(lua, "move");
  bound<shift>(lua, "insert");
  bound<shift>(lua, "remove");
  lua_pushcfunction(lua, guarded<stable_sort>);
  lua_setfield(lua, -2, "sort");
}

void add_string_library(lua_State* lua) {
  lua_pushnil(lua);
  lua_setfield(lua, -2, "dump");
  for (const char* name :
       {"byte", "char", "len", "lower", "pack", "packsize", "reverse", "sub", "unpack", "upper"})
    bound<texts>(lua, name);
  bound<repeat>(lua, "rep");
  add_pattern_functions(lua);
  lua_getfield(lua, -1, "format");
  lua_getfield(lua, -3, "tostring");  // from the globals below the library on the stack
  lua_pushcclosure(lua, guarded<format>, 2);
  lua_setfield(lua, -2, "format");

  lua_pushliteral(lua, "");  // s:upper() finds this library through the metatable of texts
  lua_getmetatable(lua, -1);
  lua_pushboolean(lua, 0);
  lua_setfield(lua, -2, "__metatable");
  lua_pop(lua, 2);
}

}  // namespace flyrock
