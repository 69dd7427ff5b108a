#pragma once
// Loads that change over time as functions in Lua scenarios: fr.over_time(function(t) ... end).

#include <vector>

struct lua_State;

namespace flyrock {

/// Each function is sampled by 1 ms, from 0 to the end of a trial, once the scenario is known. Rows that lie
/// on the line between their neighbours are left out.
class LoadFunctions {
 public:
  /// fr.over_time(f) with its argument on the stack: pushes the table that gets the rows. Throws
  /// std::runtime_error.
  void answer(lua_State* lua);
  /// Fills the tables of all functions; the scenario is at the top of the stack. Raises errors in Lua.
  void sample(lua_State* lua);
  void clear() { asked_.clear(); }

 private:
  struct Asked {
    int function, table;  ///< references
  };
  std::vector<Asked> asked_;
};

}  // namespace flyrock
