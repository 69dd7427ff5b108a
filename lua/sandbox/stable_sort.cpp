#include "sandbox/stable_sort.h"

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <numeric>
#include <vector>

#include "sandbox/budget.h"

namespace flyrock {

namespace {

// Positions on the stack: the table to sort, the comparison (or nil), a copy of the elements.
constexpr int table = 1, comparison = 2, elements = 3;

/// Charges for comparing the two values at the top of the stack if both are long texts.
void charge_texts(lua_State* lua) {
  if (lua_type(lua, -1) != LUA_TSTRING || lua_type(lua, -2) != LUA_TSTRING) return;
  const double bytes = static_cast<double>(std::min(lua_rawlen(lua, -1), lua_rawlen(lua, -2)));
  if (bytes > 100 * Budget::bytes_per_instruction) charge(lua, bytes / Budget::bytes_per_instruction);
}

/// Whether element a is less than element b.
bool less(lua_State* lua, int a, int b) {
  const bool own = lua_isnil(lua, comparison);
  if (!own) lua_pushvalue(lua, comparison);
  lua_rawgeti(lua, elements, a);
  lua_rawgeti(lua, elements, b);
  if (!own) lua_call(lua, 2, 1);
  if (own) charge_texts(lua);
  const bool is_less = own ? lua_compare(lua, -2, -1, LUA_OPLT) != 0 : lua_toboolean(lua, -1) != 0;
  lua_settop(lua, elements);
  return is_less;
}

/// Merges runs of `length` elements into runs of twice that length.
std::vector<int> merge_runs(lua_State* lua, const std::vector<int>& order, std::size_t length) {
  std::vector<int> merged;
  merged.reserve(order.size());
  for (std::size_t start = 0; start < order.size(); start += 2 * length) {
    const std::size_t middle = std::min(start + length, order.size()),
                      end = std::min(middle + length, order.size());
    std::size_t left = start, right = middle;
    while (left < middle && right < end)
      merged.push_back(less(lua, order[right], order[left]) ? order[right++] : order[left++]);
    merged.insert(merged.end(), order.begin() + left, order.begin() + middle);
    merged.insert(merged.end(), order.begin() + right, order.begin() + end);
  }
  return merged;
}

}  // namespace

int stable_sort(lua_State* lua) {
  luaL_checktype(lua, table, LUA_TTABLE);
  const lua_Integer length = luaL_len(lua, table);
  if (length < 2) return 0;
  charge(lua, static_cast<double>(length) *
                  std::log2(static_cast<double>(length)));  // upper bound of the number of comparisons
  if (!lua_isnoneornil(lua, comparison)) luaL_checktype(lua, comparison, LUA_TFUNCTION);
  lua_settop(lua, comparison);
  lua_createtable(lua, static_cast<int>(length), 0);
  for (int i = 1; i <= length; ++i) {
    lua_geti(lua, table, i);
    lua_rawseti(lua, elements, i);
  }
  std::vector<int> order(static_cast<std::size_t>(length));
  std::iota(order.begin(), order.end(), 1);
  for (std::size_t run = 1; run < order.size(); run *= 2) order = merge_runs(lua, order, run);
  for (int i = 1; i <= length; ++i) {
    lua_rawgeti(lua, elements, order[static_cast<std::size_t>(i - 1)]);
    lua_seti(lua, table, i);
  }
  return 0;
}

}  // namespace flyrock
