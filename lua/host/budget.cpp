#include "host/budget.h"

#include <fmt/format.h>

#include <cstdlib>
#include <lua.hpp>

namespace flyrock {

namespace {

/// What is over its limit after `instructions` more, or an empty text.
std::string spend(Budget& budget, double instructions) {
  budget.left -= instructions;
  if (budget.left < 0) return fmt::format("used more than its {:.0f} instructions", budget.limit);
  const auto now = std::chrono::steady_clock::now();
  if (!budget.timed) {
    budget.timed = true;
    budget.start = now;
  }
  if (now - budget.start > Budget::time_limit)
    return fmt::format("ran for more than {} s", Budget::time_limit.count());
  return {};
}

/// `level` is that of the Lua function to name: 0 in a hook, 1 in a C function.
void spend_or_raise(lua_State* lua, double instructions, int level) {
  Budget& budget = budget_of(lua);
  if (budget.exceeded.empty()) budget.exceeded = spend(budget, instructions);
  if (budget.exceeded.empty()) return;
  luaL_where(lua, level);
  lua_pushstring(lua, budget.exceeded.c_str());
  lua_concat(lua, 2);
  lua_error(lua);
}

void look(lua_State* lua, lua_Debug*) { spend_or_raise(lua, Budget::interval, 0); }

}  // namespace

std::string Budget::memory_text() {
  return fmt::format("needed more than {} MiB of memory", memory_limit >> 20);
}

void Budget::arm(double instructions) {
  limit = left = instructions;
  timed = false;
  exceeded.clear();
}

Budget& budget_of(lua_State* lua) { return **static_cast<Budget**>(lua_getextraspace(lua)); }

void* allocate(void* data, void* block, std::size_t old_size, std::size_t new_size) {
  constexpr std::size_t large = 1 << 16;
  constexpr double bytes_per_instruction = 64;
  Budget& budget = *static_cast<Budget*>(data);
  if (!block) old_size = 0;  // Lua then passes the kind of object
  if (new_size == 0) {
    std::free(block);
    budget.memory -= old_size;
    return nullptr;
  }
  if (new_size > old_size) {
    if (budget.memory - old_size + new_size > Budget::memory_limit) return nullptr;
    if (new_size > large) budget.left -= static_cast<double>(new_size) / bytes_per_instruction;
  }
  void* moved = std::realloc(block, new_size);
  if (moved) budget.memory += new_size - old_size;
  return moved;
}

void count_instructions(lua_State* lua) { lua_sethook(lua, look, LUA_MASKCOUNT, Budget::interval); }

void charge(lua_State* lua, double instructions) { spend_or_raise(lua, instructions, 1); }

void raise_if_exceeded(lua_State* lua) {
  Budget& budget = budget_of(lua);
  // Lua's own text; the status would not do, since coroutine.wrap raises it as an ordinary error.
  if (lua_type(lua, -1) == LUA_TSTRING && std::string_view(lua_tostring(lua, -1)) == "not enough memory")
    budget.exceeded = Budget::memory_text();
  if (!budget.exceeded.empty()) lua_error(lua);
}

}  // namespace flyrock
