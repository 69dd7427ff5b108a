#include "host/load_functions.h"

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <stdexcept>

#include "units/units.h"

namespace flyrock {

namespace {

constexpr double interval = 1e-3;  // s

using Sample = std::vector<double>;

/// The end of a trial [s]; 0 if the scenario gives none, which is reported where it is read.
double stop_time_of(lua_State* lua) {
  double until = 0;
  lua_pushstring(lua, "stop");
  if (lua_rawget(lua, -2) == LUA_TTABLE) {
    lua_pushstring(lua, "time");
    const int type = lua_rawget(lua, -2);
    if (type == LUA_TNUMBER) until = lua_tonumber(lua, -1);
    if (type == LUA_TSTRING)
      if (const auto quantity = parse_quantity(lua_tostring(lua, -1))) until = quantity->si();
    lua_pop(lua, 1);
  }
  lua_pop(lua, 1);
  return until;
}

/// What the function answers at a time. It is at the top of the stack.
Sample sample_at(lua_State* lua, double time) {
  const auto refuse = [&] {
    luaL_error(lua, "a function of fr.over_time returns a %s at %f s, expected a number or a list of numbers",
               luaL_typename(lua, -1), time);
  };
  lua_pushvalue(lua, -1);
  lua_pushnumber(lua, time);
  lua_call(lua, 1, 1);
  Sample sample;
  if (lua_type(lua, -1) == LUA_TNUMBER) {
    sample.push_back(lua_tonumber(lua, -1));
  } else if (lua_istable(lua, -1)) {
    const auto length = static_cast<lua_Integer>(lua_rawlen(lua, -1));
    if (length == 0 || length > 3) refuse();
    for (lua_Integer k = 1; k <= length; ++k) {
      if (lua_rawgeti(lua, -1, k) != LUA_TNUMBER) refuse();
      sample.push_back(lua_tonumber(lua, -1));
      lua_pop(lua, 1);
    }
  } else {
    refuse();
  }
  lua_pop(lua, 1);
  return sample;
}

/// Whether the sample between these two, at the share `s` of the time, lies on their line.
bool is_on_line(const Sample& from, const Sample& sample, const Sample& to, double s) {
  constexpr double rounding = 1e-12;
  if (from.size() != sample.size() || to.size() != sample.size()) return false;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double scale = std::max({std::abs(from[k]), std::abs(to[k]), std::abs(sample[k])});
    if (std::abs(from[k] + s * (to[k] - from[k]) - sample[k]) > rounding * scale) return false;
  }
  return true;
}

/// Appends { time, value } to the list at the top of the stack.
void push_row(lua_State* lua, double time, const Sample& sample) {
  lua_createtable(lua, 2, 0);
  lua_pushnumber(lua, time);
  lua_rawseti(lua, -2, 1);
  if (sample.size() == 1) {
    lua_pushnumber(lua, sample.front());
  } else {
    lua_createtable(lua, static_cast<int>(sample.size()), 0);
    for (std::size_t k = 0; k < sample.size(); ++k) {
      lua_pushnumber(lua, sample[k]);
      lua_rawseti(lua, -2, static_cast<lua_Integer>(k) + 1);
    }
  }
  lua_rawseti(lua, -2, 2);
  lua_rawseti(lua, -2, static_cast<lua_Integer>(lua_rawlen(lua, -2)) + 1);
}

}  // namespace

void LoadFunctions::answer(lua_State* lua) {
  if (!lua_isfunction(lua, 1))
    throw std::runtime_error(
        "fr.over_time takes a function of the time in seconds, as fr.over_time(function(t) return 2 * t "
        "end)");
  lua_settop(lua, 1);
  lua_createtable(lua, 0, 1);
  lua_pushvalue(lua, -1);
  const int table = luaL_ref(lua, LUA_REGISTRYINDEX);
  lua_pushvalue(lua, 1);
  asked_.push_back({luaL_ref(lua, LUA_REGISTRYINDEX), table});
}

void LoadFunctions::sample(lua_State* lua) {
  if (asked_.empty()) return;
  const auto last = std::max<lua_Integer>(1, std::llround(std::ceil(stop_time_of(lua) / interval - 1e-6)));
  for (const Asked& asked : asked_) {
    luaL_checkstack(lua, 8, "too many values");
    lua_rawgeti(lua, LUA_REGISTRYINDEX, asked.table);
    lua_createtable(lua, 0, 0);
    lua_rawgeti(lua, LUA_REGISTRYINDEX, asked.function);
    lua_Integer kept = 0;
    Sample row = sample_at(lua, 0), before = row;
    const auto keep = [&](lua_Integer k, const Sample& sample) {
      lua_pushvalue(lua, -2);  // the list
      push_row(lua, static_cast<double>(k) * interval, sample);
      lua_pop(lua, 1);
      kept = k;
      row = sample;
    };
    keep(0, row);
    for (lua_Integer k = 1; k <= last; ++k) {
      Sample now = sample_at(lua, static_cast<double>(k) * interval);
      const double share = static_cast<double>(k - 1 - kept) / static_cast<double>(k - kept);
      if (k - 1 > kept && !is_on_line(row, before, now, share)) keep(k - 1, before);
      before = std::move(now);
    }
    keep(last, before);
    lua_pop(lua, 1);  // the function
    lua_setfield(lua, -2, "table");
    lua_pop(lua, 1);
  }
}

}  // namespace flyrock
