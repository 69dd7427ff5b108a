#include "host/read_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <set>

#include "document/printable.h"
#include "sandbox/read_only.h"
#include "units/units.h"

namespace flyrock {

namespace {

class Reader {
 public:
  Reader(lua_State* lua, const FieldPlaces& places, Diagnostics& diagnostics, const FunctionSink& functions)
      : lua_(lua), places_(places), diagnostics_(diagnostics), functions_(functions) {}

  bool failed() const { return failed_; }

  /// Reads the value at the top of the stack and leaves it there (a view is replaced by its table).
  Value read(const std::string& path) {
    Value value;
    value.at = path.empty() ? places_.call() : places_.value(path);
    if (++count_ > 100'000) {
      if (count_ == 100'001) fail(path, "more than 100,000 values");
      return value;
    }
    switch (lua_type(lua_, -1)) {
      case LUA_TBOOLEAN:
        value.data = lua_toboolean(lua_, -1) != 0;
        break;
      case LUA_TNUMBER:
        value.data = number(path);
        value.rounded = may_be_rounded();
        break;
      case LUA_TSTRING: {
        std::size_t length;
        const char* text = lua_tolstring(lua_, -1, &length);
        value.data = std::string(text, length);
        if (const std::string fault = text_fault({text, length}); !fault.empty())
          fail(path, "a text that " + fault);
        break;
      }
      case LUA_TTABLE:
        table(path, value);
        break;
      case LUA_TFUNCTION:
        if (!functions_(path))
          fail(path, "a function, expected a value: functions may stand only in fr.plugin");
        break;
      default:
        fail(path,
             fmt::format("a {}, expected a number, text, true, false or a table", luaL_typename(lua_, -1)));
    }
    return value;
  }

 private:
  void fail(const std::string& path, const std::string& text) {
    failed_ = true;
    diagnostics_.error(path.empty() ? places_.call() : places_.value(path), path, text);
  }

  static bool exact(lua_Integer integer) {
    constexpr auto limit = static_cast<lua_Integer>(greatest_whole);
    return -limit <= integer && integer <= limit;
  }

  /// A Lua number that is no integer has lost its last digits from 2^53 on, if it had any.
  bool may_be_rounded() const {
    return !lua_isinteger(lua_, -1) && std::abs(lua_tonumber(lua_, -1)) >= greatest_whole;
  }

  double number(const std::string& path) {
    const double number = lua_tonumber(lua_, -1);
    if (!std::isfinite(number))
      fail(path, fmt::format("{}, expected a finite number", std::isnan(number) ? "nan" : "inf"));
    else if (lua_isinteger(lua_, -1) && !exact(lua_tointeger(lua_, -1)))
      fail(path, fmt::format("{}, expected a whole number of at most 2^53", lua_tointeger(lua_, -1)));
    return number;
  }

  void table(const std::string& path, Value& value) {
    if (!see_through(lua_))
      return fail(path,
                  "a plugin or a library, expected a value: a plugin is used by its name, type = \"NAME\"");
    const void* identity = lua_topointer(lua_, -1);
    if (std::find(open_.begin(), open_.end(), identity) != open_.end())
      return fail(path, "a table that holds itself, expected a value");
    if (open_.size() > 100) return fail(path, "tables nested more than 100 deep");
    luaL_checkstack(lua_, 4, "tables nested too deeply");
    open_.push_back(identity);
    const auto length = static_cast<lua_Integer>(lua_rawlen(lua_, -1));
    bool is_map = false;
    Map map;
    std::size_t positions = 0;
    std::set<std::string> odd_keys;  // types of these keys, sorted, because Lua's order depends on addresses
    for (lua_pushnil(lua_); lua_next(lua_, -2); lua_pop(lua_, 1)) {
      if (lua_type(lua_, -2) == LUA_TSTRING) {
        is_map = true;
        if (const std::string fault = text_fault(lua_tostring(lua_, -2)); !fault.empty())
          fail(path, "a key that " + fault);
        map.push_back({lua_tostring(lua_, -2), {}, {}});
      } else if (lua_isinteger(lua_, -2) && lua_tointeger(lua_, -2) >= 1 &&
                 lua_tointeger(lua_, -2) <= length) {
        ++positions;
      } else {
        odd_keys.insert(luaL_typename(lua_, -2));
      }
    }
    for (const std::string& type : odd_keys)
      fail(path, fmt::format("a key that is a {}, expected texts, or positions from 1 without gaps", type));
    if (is_map && positions > 0)
      fail(path, "a table with both names and positions, expected a map or a list");
    else if (is_map)
      fields(path, std::move(map), value);
    else
      list(path, length, value);
    open_.pop_back();
  }

  void list(const std::string& path, lua_Integer length, Value& value) {
    List items;
    for (lua_Integer i = 0; i < length; ++i) {
      const std::string item = join_path(path, static_cast<std::size_t>(i));
      if (lua_rawgeti(lua_, -1, i + 1) == LUA_TNIL)
        fail(item, "nothing, expected a value: a list has no gaps");
      else
        items.push_back(read(item));
      lua_pop(lua_, 1);
    }
    value.data = std::move(items);
  }

  void fields(const std::string& path, Map map, Value& value) {
    std::sort(map.begin(), map.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    Map read_map;
    for (Entry& entry : map) {
      const std::string field = join_path(path, entry.key);
      entry.at = places_.key(field);
      lua_pushlstring(lua_, entry.key.data(), entry.key.size());
      const bool function = lua_rawget(lua_, -2) == LUA_TFUNCTION;
      entry.value = read(field);
      lua_pop(lua_, 1);
      if (!function) read_map.push_back(std::move(entry));
    }
    value.data = std::move(read_map);
  }

  lua_State* lua_;
  const FieldPlaces& places_;
  Diagnostics& diagnostics_;
  const FunctionSink& functions_;
  std::vector<const void*> open_;  // tables that contain the current one
  int count_ = 0;
  bool failed_ = false;
};

}  // namespace

std::optional<Value> read_value(lua_State* lua, int index, const FieldPlaces& places,
                                Diagnostics& diagnostics, const FunctionSink& functions) {
  Reader reader(lua, places, diagnostics, functions);
  lua_pushvalue(lua, index);
  Value value = reader.read("");
  lua_pop(lua, 1);
  if (reader.failed()) return std::nullopt;
  return value;
}

}  // namespace flyrock
