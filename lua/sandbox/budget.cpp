#include "sandbox/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <lua.hpp>

#include "sandbox/state.h"

namespace flyrock {

namespace {

constexpr const char* out_of_memory = "needed more than 256 MiB of memory";
static_assert(Budget::memory_limit == 256 << 20 && Budget::text_limit == 1 << 20);

/// The processor time of this thread.
std::chrono::nanoseconds processor_time() {
  timespec time;
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// The limit that is exceeded after `instructions` more; empty if none is.
std::string spend(Budget& budget, double instructions) {
  budget.left -= instructions;
  if (budget.left < 0) return fmt::format("used more than its {:.0f} instructions", budget.limit);
  const auto now = std::chrono::steady_clock::now();
  if (!budget.timed) {
    budget.timed = true;
    budget.start = now;
    budget.processor_start = processor_time();
  }
  // A busy machine is not the plugin's fault, so processor time decides. Reading it takes longer, so it is
  // read only if the wall time is over the limit.
  if (now - budget.start > budget.time_limit && processor_time() - budget.processor_start > budget.time_limit)
    return fmt::format("ran for more than {} s", std::chrono::duration<double>(budget.time_limit).count());
  return {};
}

/// `level` is the level of the Lua function to name: 0 in a hook, 1 in a C function.
void spend_or_raise(lua_State* lua, double instructions, int level) {
  const Budget& budget = budget_of(lua);
  const std::string over = budget.exceeded.empty() ? spend(budget_of(lua), instructions) : budget.exceeded;
  if (!over.empty()) exceed(lua, over, level);
}

void look(lua_State* lua, lua_Debug*) { spend_or_raise(lua, Budget::interval, 0); }

/// Why a block of memory is refused; null if it is not.
const char* refusal(const Budget& budget, bool text, std::size_t more, std::size_t size) {
  if (text && size > Budget::text_limit) return Budget::long_text;
  if (budget.memory + more > Budget::memory_limit) return out_of_memory;
  return nullptr;
}

}  // namespace

void Budget::arm(double instructions) {
  limit = left = instructions;
  time_limit = std::min<std::chrono::nanoseconds>(static_cast<std::int64_t>(instructions) * instruction_time,
                                                  longest_time);
  timed = false;
  refused = "";
  raised_at.clear();
  exceeded.clear();
}

std::string place_of(lua_State* lua) {
  lua_Debug frame;
  for (int level = 0; lua && lua_getstack(lua, level, &frame); ++level)
    if (lua_getinfo(lua, "Sl", &frame) && frame.currentline > 0)
      return fmt::format("{}:{}: ", frame.short_src, frame.currentline);
  return {};
}

Budget& budget_of(lua_State* lua) { return **static_cast<Budget**>(lua_getextraspace(lua)); }

void* allocate(void* data, void* block, std::size_t old_size, std::size_t new_size) {
  constexpr std::size_t large = 1 << 16;
  constexpr double filled_per_instruction = 256;  // bytes
  Budget& budget = *static_cast<Budget*>(data);
  const bool text = !block && old_size == LUA_TSTRING;  // for a new block Lua passes the type of the object
  if (!block) old_size = 0;
  if (new_size == 0) {
    std::free(block);
    budget.memory -= old_size;
    return nullptr;
  }
  if (new_size > old_size) {
    if (const char* why = refusal(budget, text, new_size - old_size, new_size)) {
      budget.refused = why;
      budget.refused_at = place_of(budget.lua);
      return nullptr;
    }
    if (new_size > large) budget.left -= static_cast<double>(new_size) / filled_per_instruction;
  }
  void* moved = std::realloc(block, new_size);
  if (moved)
    budget.memory += new_size - old_size;
  else
    budget.refused = "needed more memory than the machine has left", budget.refused_at = place_of(budget.lua);
  return moved;
}

void count_instructions(lua_State* lua) { lua_sethook(lua, look, LUA_MASKCOUNT, Budget::interval); }

void charge(lua_State* lua, double instructions) { spend_or_raise(lua, instructions, 1); }

void exceed(lua_State* lua, const std::string& text, int level) {
  budget_of(lua).exceeded = text;
  raise(lua, text, level);
}

void raise_if_exceeded(lua_State* lua) {
  name_refusal(lua);
  if (!budget_of(lua).exceeded.empty()) lua_error(lua);
}

void name_refusal(lua_State* lua) {
  // The status is not enough: coroutine.wrap raises the same text as an ordinary error.
  Budget& budget = budget_of(lua);
  if (!*budget.refused || lua_type(lua, -1) != LUA_TSTRING) return;
  if (std::string_view(lua_tostring(lua, -1)) != "not enough memory") return;
  budget.exceeded = budget.refused;
  lua_pop(lua, 1);
  lua_pushfstring(lua, "%s%s", budget.refused_at.c_str(), budget.refused);
}

}  // namespace flyrock
