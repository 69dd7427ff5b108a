#include "host/state.h"

#include <fmt/format.h>

#include <exception>
#include <lua.hpp>
#include <new>

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
  } catch (const std::exception&) {  // kept aside: Lua would lose it
    call.thrown = std::current_exception();
  }
  return 0;
}

std::string error_text(lua_State* lua) {
  if (lua_type(lua, -1) == LUA_TSTRING) return lua_tostring(lua, -1);
  return fmt::format("raised an error that is no text but a {}", luaL_typename(lua, -1));
}

}  // namespace

LuaState::LuaState() : budget_(std::make_unique<Budget>()) {
  lua_ = lua_newstate(allocate, budget_.get());
  if (!lua_) throw std::bad_alloc();
  *static_cast<Budget**>(lua_getextraspace(lua_)) = budget_.get();
}

LuaState::~LuaState() { lua_close(lua_); }

void LuaState::run_protected(double instructions, Body body, void* data) {
  ProtectedBody call{body, data, nullptr};
  budget_->arm(instructions);
  count_instructions(lua_);
  lua_pushcfunction(lua_, call_body);
  lua_pushlightuserdata(lua_, &call);
  const int status = lua_pcall(lua_, 1, 0, 0);
  if (status != LUA_OK) {
    const std::string text = error_text(lua_);
    lua_settop(lua_, 0);
    throw LuaError(text == "not enough memory" ? budget_->memory_text() : text);
  }
  if (call.thrown) std::rethrow_exception(call.thrown);
}

void LuaState::release(int reference) {
  run(Budget::call_limit, [&](lua_State* lua) { luaL_unref(lua, LUA_REGISTRYINDEX, reference); });
}

void raise(lua_State* lua, const std::string& text) {
  luaL_where(lua, 1);
  lua_pushlstring(lua, text.data(), text.size());
  lua_concat(lua, 2);
  lua_error(lua);
  std::terminate();  // lua_error does not return
}

}  // namespace flyrock
