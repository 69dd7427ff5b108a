// string.find, match, gmatch and gsub on PatternMatcher.

#include <cctype>
#include <cstring>
#include <lua.hpp>

#include "sandbox/budget.h"
#include "sandbox/pattern.h"

namespace flyrock {

namespace {

std::string_view text_at(lua_State* lua, int index) {
  std::size_t length;
  const char* text = luaL_checklstring(lua, index, &length);
  return {text, length};
}

/// The offset, from 0, of an optional position; beyond the end if there is no such place.
std::size_t start_at(lua_State* lua, int index, std::size_t length) {
  const lua_Integer position = luaL_optinteger(lua, index, 1);
  if (position > 0) return static_cast<std::size_t>(position) - 1;
  if (position == 0 || position < -static_cast<lua_Integer>(length)) return 0;
  return length + static_cast<std::size_t>(position);
}

/// Finds a text without patterns and charges for the comparisons.
const char* find_plain(lua_State* lua, std::string_view subject, std::string_view text, std::size_t from) {
  const char* end = subject.data() + subject.size();
  const char* s = subject.data() + from;
  if (text.empty()) return s;
  while (static_cast<std::size_t>(end - s) >= text.size()) {
    const auto* first = static_cast<const char*>(std::memchr(s, text[0], end - s - text.size() + 1));
    charge(lua, (static_cast<double>((first ? first : end) - s) + static_cast<double>(text.size())) /
                    Budget::bytes_per_instruction);
    if (!first) return nullptr;
    if (std::memcmp(first, text.data(), text.size()) == 0) return first;
    s = first + 1;
  }
  return nullptr;
}

int search(lua_State* lua, bool find) {
  const std::string_view subject = text_at(lua, 1);
  std::string_view pattern = text_at(lua, 2);
  const std::size_t from = start_at(lua, 3, subject.size());
  if (from > subject.size()) {
    lua_pushnil(lua);
    return 1;
  }
  if (find && (lua_toboolean(lua, 4) || pattern.find_first_of("^$*+?.([%-") == pattern.npos)) {
    if (const char* found = find_plain(lua, subject, pattern, from)) {
      lua_pushinteger(lua, found - subject.data() + 1);
      lua_pushinteger(lua, found - subject.data() + static_cast<std::ptrdiff_t>(pattern.size()));
      return 2;
    }
    lua_pushnil(lua);
    return 1;
  }
  const bool anchored = pattern.starts_with('^');
  if (anchored) pattern.remove_prefix(1);
  PatternMatcher matcher(lua, subject, pattern);
  const char* last = subject.data() + subject.size();
  for (const char* s = subject.data() + from; s <= last; ++s) {
    if (const char* end = matcher.match(s)) {
      if (!find) return matcher.push_captures(s, end);
      lua_pushinteger(lua, s - subject.data() + 1);
      lua_pushinteger(lua, end - subject.data());
      return matcher.push_captures(nullptr, nullptr) + 2;
    }
    if (anchored) break;
  }
  lua_pushnil(lua);
  return 1;
}

int find(lua_State* lua) { return search(lua, true); }
int match(lua_State* lua) { return search(lua, false); }

/// Upvalues: subject, pattern, where to continue, the end of the last match (or -1).
int next_match(lua_State* lua) {
  const std::string_view subject = text_at(lua, lua_upvalueindex(1));
  const auto from = static_cast<std::size_t>(lua_tointeger(lua, lua_upvalueindex(3)));
  const lua_Integer previous = lua_tointeger(lua, lua_upvalueindex(4));
  PatternMatcher matcher(lua, subject, text_at(lua, lua_upvalueindex(2)));
  for (std::size_t i = from; i <= subject.size(); ++i) {
    const char* s = subject.data() + i;
    const char* end = matcher.match(s);
    if (!end || end - subject.data() == previous)
      continue;  // skips an empty match at the end of the last match
    lua_pushinteger(lua, end - subject.data());
    lua_pushvalue(lua, -1);
    lua_replace(lua, lua_upvalueindex(3));
    lua_replace(lua, lua_upvalueindex(4));
    return matcher.push_captures(s, end);
  }
  return 0;
}

int all_matches(lua_State* lua) {
  const std::string_view subject = text_at(lua, 1);
  text_at(lua, 2);
  const std::size_t from = std::min(start_at(lua, 3, subject.size()), subject.size() + 1);
  lua_settop(lua, 2);
  lua_pushinteger(lua, static_cast<lua_Integer>(from));
  lua_pushinteger(lua, -1);
  lua_pushcclosure(lua, next_match, 4);
  return 1;
}

/// Adds a replacement text with %0 to %9 filled in.
void add_text(lua_State* lua, luaL_Buffer& result, const PatternMatcher& matcher, const char* start,
              const char* end) {
  const std::string_view text = text_at(lua, 3);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      luaL_addchar(&result, text[i]);
      continue;
    }
    const char next = ++i < text.size() ? text[i] : '\0';
    if (next == '%') {
      luaL_addchar(&result, next);
    } else if (next == '0') {
      luaL_addlstring(&result, start, end - start);
    } else if (std::isdigit(static_cast<unsigned char>(next))) {
      matcher.push_capture(next - '1', start, end);
      luaL_tolstring(lua, -1, nullptr);  // converts a position, which is a number
      lua_remove(lua, -2);
      luaL_addvalue(&result);
    } else {
      luaL_error(lua, "invalid use of '%%' in replacement string");
    }
  }
}

void add_replacement(lua_State* lua, luaL_Buffer& result, const PatternMatcher& matcher, const char* start,
                     const char* end) {
  const int type = lua_type(lua, 3);
  if (type == LUA_TFUNCTION) {
    lua_pushvalue(lua, 3);
    lua_call(lua, matcher.push_captures(start, end), 1);
  } else if (type == LUA_TTABLE) {
    matcher.push_capture(0, start, end);
    lua_gettable(lua, 3);
  } else {
    return add_text(lua, result, matcher, start, end);
  }
  if (!lua_toboolean(lua, -1)) {
    lua_pop(lua, 1);
    luaL_addlstring(&result, start, end - start);
  } else if (lua_isstring(lua, -1)) {
    luaL_addvalue(&result);
  } else {
    luaL_error(lua, "invalid replacement value (a %s)", luaL_typename(lua, -1));
  }
}

int replace(lua_State* lua) {
  const std::string_view subject = text_at(lua, 1);
  std::string_view pattern = text_at(lua, 2);
  const int type = lua_type(lua, 3);
  luaL_argexpected(lua,
                   type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE,
                   3, "string/function/table");
  const lua_Integer most = luaL_optinteger(lua, 4, static_cast<lua_Integer>(subject.size()) + 1);
  const bool anchored = pattern.starts_with('^');
  if (anchored) pattern.remove_prefix(1);
  PatternMatcher matcher(lua, subject, pattern);
  const char *s = subject.data(), *last = s + subject.size(), *previous = nullptr;
  lua_Integer count = 0;
  luaL_Buffer result;
  luaL_buffinit(lua, &result);
  while (count < most) {
    const char* end = matcher.match(s);
    if (end && end != previous) {
      ++count;
      charge(lua, 1);
      add_replacement(lua, result, matcher, s, end);
      s = previous = end;
    } else if (s < last) {
      luaL_addchar(&result, *s++);
    } else {
      break;
    }
    if (anchored) break;
  }
  luaL_addlstring(&result, s, last - s);
  luaL_pushresult(&result);
  lua_pushinteger(lua, count);
  return 2;
}

}  // namespace

void add_pattern_functions(lua_State* lua) {
  constexpr luaL_Reg functions[] = {
      {"find", find}, {"match", match}, {"gmatch", all_matches}, {"gsub", replace}, {nullptr, nullptr}};
  luaL_setfuncs(lua, functions, 0);
}

}  // namespace flyrock
