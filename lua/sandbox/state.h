#pragma once
// A Lua state with protected calls.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "sandbox/budget.h"

namespace flyrock {

/// An error that Lua raised: "my_law.lua:16: attempt to perform arithmetic on a nil value".
struct LuaError : std::runtime_error {
  LuaError(const std::string& text, std::string at) : std::runtime_error(text), raised_at(std::move(at)) {}
  std::string
      raised_at;  ///< "my_law.lua:16: ", even if the text claims another place; empty if no Lua code ran
};

/// Owns a state. Only the body of a `run` may touch it, because there Lua errors, including out of memory,
/// have a frame that catches them. Lua is built as C++, so its errors unwind C++ frames.
class LuaState {
 public:
  explicit LuaState(const Wording& wording);  ///< throws std::bad_alloc
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  /// Runs body(lua_State*) with an empty stack in a protected call. Throws LuaError for a Lua error;
  /// exceptions of the body pass through.
  template <class Body>
  void run(double instructions, Body&& body) {
    run_protected(
        instructions,
        [](void* data, lua_State* lua) { (*static_cast<std::remove_reference_t<Body>*>(data))(lua); }, &body);
  }

  /// Releases a value kept with luaL_ref.
  void release(int reference);

  /// From here on `print` writes nothing and its lines wait to be taken. Drops lines printed before.
  void collect_prints();
  /// The lines printed since the last call. Each call resets the counts of lines for each place.
  PrintLog take_prints();

 private:
  using Body = void (*)(void* data, lua_State* lua);
  void run_protected(double instructions, Body body, void* data);

  std::unique_ptr<Budget> budget_;
  lua_State* lua_;
};

/// Whether a message begins with the place of Lua code: "my_law.lua:16: ...".
bool has_place(std::string_view text);

/// Raises `text` as a Lua error with the place of the Lua function at this level, 1 from a C function.
[[noreturn]] void raise(lua_State* lua, const std::string& text, int level = 1);

/// Turns exceptions of a C++ function into Lua errors, so that they pass through Lua.
template <int (*function)(lua_State*)>
int guarded(lua_State* lua) {
  std::string text;
  try {
    return function(lua);
  } catch (const std::exception& failure) {  // Lua's own errors are not std::exceptions and pass through
    text = failure.what();
  }
  raise(lua, text);
}

}  // namespace flyrock
