#include "sandbox/state.h"

#include <fmt/format.h>

#include <exception>
#include <lua.hpp>
#include <new>
#include <utility>

namespace flyrock {

namespace {

struct ProtectedBody {
  void (*body)(void*, lua_State*);
  void* data;
  std::exception_ptr thrown;
};

int call_body(lua_State* lua) {
  auto& call = *static_cast<ProtectedBody*>(lua_touserdata(lua, 1));
  lua_settop(lua, 0);
  try {
    call.body(call.data, lua);
  } catch (const std::exception&) {  // stored aside, because Lua would lose it
    call.thrown = std::current_exception();
  }
  return 0;
}

std::string error_text(lua_State* lua) {
  if (lua_type(lua, -1) == LUA_TSTRING) {
    std::size_t length;
    const char* text = lua_tolstring(lua, -1, &length);
    return budget_of(lua).wording.printable({text, length});
  }
  return fmt::format("raised an error that is not a text but a {}", luaL_typename(lua, -1));
}

/// The message handler: adds the place if a message has none. (Memory errors do not reach it.)
int add_place(lua_State* lua) {
  std::string text = error_text(lua);
  budget_of(lua).raised_at = place_of(lua);
  if (!has_place(text)) text = budget_of(lua).raised_at + text;
  lua_pushlstring(lua, text.data(), text.size());
  return 1;
}

/// What helps against an error that Lua words for itself.
std::string cure_of(std::string_view text) {
  if (text.ends_with("C stack overflow"))
    return ": brackets, or functions that Lua calls for a function (table.sort, string.gsub, pcall, "
           "metamethods), nest deeper than 200; let them nest less";
  if (text.ends_with("stack overflow"))
    return ": a function calls itself without end, or too often; give it an end, or write a loop";
  return "";
}

}  // namespace

LuaState::LuaState(const Wording& wording) : budget_(std::make_unique<Budget>()) {
  budget_->wording = wording;
  lua_ = lua_newstate(allocate, budget_.get());
  if (!lua_) throw std::bad_alloc();
  *static_cast<Budget**>(lua_getextraspace(lua_)) = budget_.get();
  budget_->lua = lua_;
}

LuaState::~LuaState() { lua_close(lua_); }

void LuaState::run_protected(double instructions, Body body, void* data) {
  ProtectedBody call{body, data, nullptr};
  budget_->arm(instructions);
  count_instructions(lua_);
  lua_pushcfunction(lua_, add_place);
  lua_pushcfunction(lua_, call_body);
  lua_pushlightuserdata(lua_, &call);
  const int status = lua_pcall(lua_, 1, 0, -3);
  if (status != LUA_OK) {
    name_refusal(lua_);
    std::string text = error_text(lua_);
    text += cure_of(text);
    lua_settop(lua_, 0);
    throw LuaError(text, budget_->raised_at);
  }
  lua_settop(lua_, 0);
  if (call.thrown) std::rethrow_exception(call.thrown);
}

void LuaState::release(int reference) {
  run(Budget::call_limit, [&](lua_State* lua) { luaL_unref(lua, LUA_REGISTRYINDEX, reference); });
}

void LuaState::collect_prints() {
  budget_->shows_prints = false;
  budget_->prints = {};
}

PrintLog LuaState::take_prints() { return std::exchange(budget_->prints, {}); }

bool has_place(std::string_view text) {
  const std::size_t place = text.find(".lua:");
  return place != text.npos && place < text.find(": ");
}

void raise(lua_State* lua, const std::string& text, int level) {
  luaL_where(lua, level);
  lua_pushlstring(lua, text.data(), text.size());
  lua_concat(lua, 2);
  lua_error(lua);
  std::terminate();  // lua_error does not return
}

}  // namespace flyrock
