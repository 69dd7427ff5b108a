#pragma once
// Keeps plugin code without state of its own. Everything outside of a Lua function that it can reach is
// frozen before its first call. Its answer then depends only on its arguments and not on earlier calls in the
// same thread.
//
// Tables become read-only in place, metatables and closures are followed, coroutines are refused. Lua cannot
// protect local variables outside of functions, so they are compared after each call and restored.

#include <string>
#include <vector>

struct lua_State;

namespace flyrock {

/// The local variables outside of an entry function that its code could set.
class OuterLocals {
 public:
  /// Freezes everything that the function at the top of the stack can reach, and stores its outer locals.
  /// `what` names the function. Raises a Lua error if it reaches a coroutine. Leaves only the function on the
  /// stack.
  OuterLocals(lua_State* lua, const std::string& what);

  /// Restores what a call has changed. Returns the name of the first changed variable, or null.
  const char* restore(lua_State* lua) const;

  /// The owner must release it.
  int reference() const { return cells_; }

 private:
  struct Cell {
    int upvalue;
    std::string name;
  };
  std::vector<Cell> locals_;
  int cells_;  // a list of pairs: a function, then the value
};

}  // namespace flyrock
