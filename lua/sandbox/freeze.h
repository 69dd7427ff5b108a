#pragma once
// Plugins keep nothing from call to call: what a Lua function finds outside of itself is frozen before it is
// first called, so that an answer depends on its arguments alone, whatever ran before on the same thread.
//
// Tables become read-only in place, metatables and closures are followed, coroutines are refused. What Lua
// cannot protect, the local variables outside of functions, is compared after each call and put back.

#include <string>
#include <vector>

struct lua_State;

namespace flyrock {

/// The local variables outside of an entry function that its code could set.
class OuterLocals {
 public:
  /// Freezes all that the function at the top of the stack reaches, and notes its outer locals. `what` names
  /// the function. A Lua error where a coroutine is reached. Leaves nothing on the stack but the function.
  OuterLocals(lua_State* lua, const std::string& what);

  /// Puts back what a call has changed; the name of the first variable that was changed, or null.
  const char* restore(lua_State* lua) const;

  /// For the owner to release.
  int reference() const { return cells_; }

 private:
  struct Cell {
    int upvalue;
    std::string name;
  };
  std::vector<Cell> locals_;
  int cells_;  // a list: the function and the value of each, in turn
};

}  // namespace flyrock
